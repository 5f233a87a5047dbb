#pragma once

#include <string>

#include "structure_from_wifi/recording_findings.h"
#include "structure_from_wifi/snapshot.h"

namespace sfw {

/// Prints which readings the mapper refused, once for each reason. Readings of neighbours' radios
/// are normal, so they are no warning while others are used.
///
/// @param source    file or bags of the readings
/// @param findings  of the notes that are printed too; what these tell is not told again
/// @param any_used  whether the map uses any reading
void reportRejections(const std::string& source, const Rejections& rejections,
                      const RecordingFindings& findings, bool any_used);

}  // namespace sfw

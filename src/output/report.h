#pragma once

#include <string>

#include "structure_from_wifi/config.h"
#include "structure_from_wifi/data_checks.h"
#include "structure_from_wifi/snapshot.h"

namespace sfw {

/// The text of report.json: version, notes, access points with their models, rejected readings,
/// areas and settings. It contains no time of day, so the same input gives the same bytes.
std::string reportJson(const Snapshot& snapshot, const Config& config,
                       const DataFindings& findings = {});

}  // namespace sfw

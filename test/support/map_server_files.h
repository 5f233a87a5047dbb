#pragma once

#include <string>
#include <vector>

#include "files/map_server.h"
#include "support/complaint.h"
#include "support/temporary_folder.h"

namespace sfw::test {

/// A test that reads maps from a folder of its own.
class MapServerFiles : public TemporaryFolder {
 protected:
  using Rows = std::vector<std::string>;

  /// The path of a YAML file that, with an image beside it, holds these bytes.
  std::string file(const std::string& yaml, const std::string& image) const {
    write("map.pgm", image);
    return write("map.yaml", yaml);
  }

  /// What readMap complains of.
  std::string complaint(const std::string& yaml, const std::string& image) const {
    return complaintOf([&] { readMap(file(yaml, image)); });
  }

  const std::string kYaml = "image: map.pgm\nresolution: 0.1\norigin: [-1.5, 2.0, 0.0]\n";
};

}  // namespace sfw::test

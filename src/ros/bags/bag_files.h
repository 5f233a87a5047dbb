#pragma once

#include <rosbag/bag.h>

#include <memory>
#include <string>
#include <vector>

namespace sfw {

/// Bags of one recording. A recording may be split over several.
class BagFiles {
 public:
  /// Opens the bags.
  /// @throw InputError naming the file and what to do: it is no bag, or has no index.
  explicit BagFiles(const std::vector<std::string>& files);

  const std::vector<std::unique_ptr<rosbag::Bag>>& bags() const { return bags_; }

  /// The topics with messages of any type, without a leading slash.
  std::vector<std::string> topics() const;

 private:
  std::vector<std::unique_ptr<rosbag::Bag>> bags_;
};

/// Topic names are compared without a leading slash, because bags have them with and without it.
std::string plainTopic(const std::string& topic);

}  // namespace sfw

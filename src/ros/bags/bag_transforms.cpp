#include "ros/bags/bag_transforms.h"

#include <rosbag/view.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <set>

#include "ros/mapping/transform_intake.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

const std::string kStatic = "_static";

bool contains(const std::vector<std::string>& topics, const std::string& topic) {
  return std::find(topics.begin(), topics.end(), topic) != topics.end();
}

/// Whether a bag has the moving or static transforms of a topic.
bool hasTransforms(const std::vector<std::string>& topics, const std::string& topic) {
  return contains(topics, topic) || contains(topics, topic + kStatic);
}

/// Every `tf` in some namespace, without "_static".
std::set<std::string> transformTopics(const std::vector<std::string>& topics) {
  std::set<std::string> found;
  for (const std::string& topic : topics) {
    const std::string name = topic.substr(topic.rfind('/') + 1);
    if (name == "tf" || name == "tf" + kStatic) {
      found.insert(topic.substr(0, topic.size() - name.size()) + "tf");
    }
  }
  return found;
}

std::string listed(const std::set<std::string>& topics) {
  std::string text;
  for (const std::string& topic : topics) {
    text += (text.empty() ? "/" : ", /") + topic;
  }
  return text;
}

/// `tf` in the namespace of a scan, or in the nearest one above it that has transforms.
std::string besideScan(const std::string& scan_topic, const std::set<std::string>& found) {
  for (std::string name = scan_topic; !name.empty();) {
    const std::size_t slash = name.rfind('/');
    name = slash == std::string::npos ? "" : name.substr(0, slash);
    const std::string topic = name.empty() ? "tf" : name + "/tf";
    if (found.count(topic) > 0) {
      return topic;
    }
  }
  return "";
}

}  // namespace

std::string findTransformTopic(const std::vector<std::string>& topics,
                               const std::vector<std::string>& scan_topics,
                               const std::string& given) {
  const std::set<std::string> found = transformTopics(topics);
  const std::string others = found.empty() ? "" : "; it has " + listed(found);
  if (!given.empty()) {
    if (!hasTransforms(topics, plainTopic(given))) {
      throw InputError("no transform on " + given + others);
    }
    return plainTopic(given);
  }
  for (const std::string& scan_topic : scan_topics) {
    const std::string topic = besideScan(scan_topic, found);
    if (!topic.empty()) {
      return topic;
    }
  }
  if (found.empty()) {
    throw InputError(
        "no transform on /tf, so no reading has a position; record /tf and /tf_static with the "
        "scans, or name the topic with --tf-topic");
  }
  if (found.size() > 1) {
    throw InputError("transforms of several robots, on " + listed(found) +
                     "; name one with --tf-topic");
  }
  return *found.begin();
}

LoadedTransforms loadTransforms(const BagFiles& bags, const std::string& topic,
                                tf2::BufferCore& transforms, TransformWatch& watch) {
  LoadedTransforms loaded;
  rosbag::View view;
  for (const auto& bag : bags.bags()) {
    view.addQuery(*bag, rosbag::TopicQuery(std::vector<std::string>{
                            topic, "/" + topic, topic + kStatic, "/" + topic + kStatic}));
  }
  for (const rosbag::MessageInstance& message : view) {
    const auto tf = message.instantiate<tf2_msgs::TFMessage>();
    if (tf == nullptr) {
      continue;
    }
    const bool is_static = plainTopic(message.getTopic()) != topic;
    for (const geometry_msgs::TransformStamped& transform : tf->transforms) {
      if (!takeTransform(transform, message.getCallerId(), is_static, transforms, watch)) {
        ++loaded.infinite;
      } else if (!is_static) {
        loaded.times.observe(transform, message.getTime());
      }
    }
  }
  return loaded;
}

}  // namespace sfw

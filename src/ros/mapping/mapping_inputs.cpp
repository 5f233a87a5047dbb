// The inputs of the mapping nodelet: topics, and messages in the manager's threads.

#include <topic_tools/shape_shifter.h>

#include <utility>

#include "base/failure.h"
#include "ros/conversion/robot_topics.h"
#include "ros/mapping/mapping_nodelet.h"

namespace sfw {

void MappingNodelet::subscribe() {
  transform_intake_.emplace(
      getNodeHandle(), *transforms_, transform_watch_,
      [this](const std::exception& error) { noteFailure("A message of tf is left out", error); });
  const std::lock_guard<std::mutex> lock(subscribing_);
  for (Source& source : sources()) {
    const std::string topic = getNodeHandle().resolveName(source.topic);
    source.index = statistics_.add(topic, source.input->is_radio);
    subscriptions_.push_back({std::move(source), {}, false, 0});
    subscribeTo(subscriptions_.back());
  }
}

std::vector<MappingNodelet::Source> MappingNodelet::sources() const {
  const std::vector<std::string> frames = antennaFrames(ros_settings_);
  const std::vector<std::string> robots = robotNames(frames);
  std::vector<Source> sources;
  for (const Input& input : kInputs) {
    sources.push_back({&input, input.topic, frames.size() == 1 ? frames.front() : "", 0});
    for (std::size_t i = 0; frames.size() > 1 && i < frames.size(); ++i) {
      sources.push_back({&input, robots[i] + "/" + input.topic, frames[i], 0});
    }
  }
  return sources;
}

void MappingNodelet::subscribeTo(Subscription& to) {
  constexpr std::uint32_t kQueue = 1000;
  const boost::function<void(const topic_tools::ShapeShifter::ConstPtr&)> callback =
      [this, source = to.source](const topic_tools::ShapeShifter::ConstPtr& message) {
        receive(source, *message);
      };
  to.subscriber = getNodeHandle().subscribe(to.source.topic, kQueue, callback);
}

void MappingNodelet::subscribeAnew() {
  const std::lock_guard<std::mutex> lock(subscribing_);
  const std::vector<InputStatistics::Input> counts = statistics_.inputs(0.0);
  for (Subscription& subscription : subscriptions_) {
    const bool is_connected = subscription.subscriber.getNumPublishers() > 0;
    const std::size_t messages = counts[subscription.source.index].messages;
    // A publisher may have come and gone since the last call.
    const bool was_connected = subscription.was_connected || messages > subscription.messages;
    if (was_connected && !is_connected) {
      subscription.subscriber.shutdown();
      subscribeTo(subscription);
    }
    subscription.was_connected = is_connected;
    subscription.messages = messages;
  }
}

void MappingNodelet::receive(const Source& source, const topic_tools::ShapeShifter& message) {
  try {
    convert(source, toAnyMessage(message));
  } catch (const std::exception& error) {
    // An exception that leaves a callback ends the nodelet manager.
    noteFailedMessage(source, error);
  }
}

void MappingNodelet::convert(const Source& source, const AnyMessage& message) {
  Conversion conversion = source.input->convert(
      message, {ros::Time::now(), source.antenna_frame, config_.path.footprint_radius_m,
                toScanFormat(scan_settings_), antennaFrames(ros_settings_)});
  statistics_.count(source.index, conversion, ros::SteadyTime::now().toSec());
  if (localisation_) {
    localisation_->add(conversion.observations);
  }
  if (paused_) {
    return;
  }
  queue_->push(std::move(conversion.observations));
  warnOfProblem(source.topic, conversion.problem);
  for (const auto& [reason, count] : conversion.rejected) {
    warnOfProblem(source.topic, reason);
  }
}

void MappingNodelet::warnOfProblem(const std::string& topic, const std::string& problem) {
  if (!problem.empty() && announcements_.isNews(topic + ": " + problem)) {
    NODELET_WARN_STREAM(topic << ": " << problem
                              << ". This is said once; /diagnostics has the counts");
  }
}

void MappingNodelet::noteFailedMessage(const Source& source, const std::exception& error) noexcept {
  try {
    const std::string problem = std::string("it could not be processed: ") + reasonOf(error);
    statistics_.count(source.index, rejection(problem), ros::SteadyTime::now().toSec());
    if (announcements_.isNews(source.topic + " failed", problem)) {
      NODELET_ERROR_STREAM("A message on " << source.topic << " is left out: " << problem);
    }
  } catch (const std::exception&) {
    // Not even the memory for the text is there; the next message may be told.
  }
}

}  // namespace sfw

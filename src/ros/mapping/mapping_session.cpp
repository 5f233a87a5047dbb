// Sessions of the mapping nodelet: saved, loaded, and taken up again.

#include <algorithm>
#include <filesystem>

#include "base/failure.h"
#include "files/atomic_file.h"
#include "files/map_server.h"
#include "ros/mapping/mapping_nodelet.h"
#include "ros/mapping/session.h"
#include "structure_from_wifi/map_files.h"
#include "structure_from_wifi/map_notes.h"

namespace sfw {
namespace {

constexpr char kPlainName[] =
    "directory must be a name of letters, digits, '.', '_' and '-' that does not start with '.'";

}  // namespace

std::string MappingNodelet::whyNothingToSave() const {
  const std::string reason = whyNoReading(status());
  return "there are no readings yet" + (reason.empty() ? "" : "; " + reason);
}

void MappingNodelet::forgetDirectories() {
  if (forget_directories_.exchange(false)) {
    own_directories_.clear();
  }
}

std::string MappingNodelet::directoryToSave(const std::string& name) {
  forgetDirectories();
  const std::string wanted = withHome(ros_settings_.save_directory) + "/" + name;
  std::string directory = wanted;
  for (int i = 2; own_directories_.count(directory) == 0 && holdsReadings(directory); ++i) {
    directory = wanted + "_" + std::to_string(i);
  }
  return directory;
}

bool MappingNodelet::saveMap(const structure_from_wifi::SaveMap::Request& request,
                             structure_from_wifi::SaveMap::Response& response) {
  response.success = 0;
  if (!isPlainName(request.directory)) {
    response.message = kPlainName;
    return true;
  }
  try {
    locateObservations();
    const Mapping mapping = publishMap(Checks::kAll);
    if (!mapping.snapshot) {
      response.message = "the map was not saved: the mapping node is shutting down";
      return true;
    }
    const Mapper& mapper = mapping.copy.mapper;
    if (mapper.readings().empty()) {
      response.message = "nothing was saved: " + whyNothingToSave();
      return true;
    }
    const std::string directory = directoryToSave(request.directory);
    for (const MapNote& note : mapNotes(*mapping.snapshot, mapping.findings)) {
      NODELET_WARN_STREAM(note.text);
    }
    writeRecording(mapper.readings(), mapper.contacts(), *mapping.snapshot, directory,
                   mapper.poses());
    writeMapFiles(*mapping.snapshot, config_, directory, mapping.findings);
    own_directories_.insert(directory);
    response.success = 1;
    response.message = directory;
  } catch (const std::exception& error) {
    response.message = reasonOf(error);
  }
  return true;
}

bool MappingNodelet::loadMap(const structure_from_wifi::LoadMap::Request& request,
                             structure_from_wifi::LoadMap::Response& response) {
  response.success = 0;
  if (!isPlainName(request.directory)) {
    response.message = kPlainName;
    return true;
  }
  const std::string directory = withHome(ros_settings_.save_directory) + "/" + request.directory;
  try {
    response.message = addSession(directory);
    forgetDirectories();
    own_directories_.insert(directory);  // the present session holds all of it
    response.success = 1;
  } catch (const std::exception& error) {
    response.message = std::string("nothing was loaded: ") + reasonOf(error);
  }
  return true;
}

std::string MappingNodelet::addSession(const std::string& directory) {
  const Session session = readSession(directory, config_.map);
  const std::size_t elsewhere = mapper_->add(session);
  refreshWhollyAnew();
  std::string text = "added " + std::to_string(session.readings.size()) + " readings and " +
                     std::to_string(session.contacts.size()) + " contacts of " + directory;
  if (elsewhere > 0) {
    text += "; " + std::to_string(elsewhere) +
            " access points keep their present position, which differs from the saved one";
  }
  return text;
}

std::string MappingNodelet::autosaveDirectory() const {
  // Robots in namespaces of their own may share the directory.
  std::string robot = getNodeHandle().getNamespace();
  std::replace(robot.begin(), robot.end(), '/', '_');
  return withHome(ros_settings_.save_directory) + "/autosave" + (robot == "_" ? "" : robot);
}

void MappingNodelet::resumeOnce() {
  if (resumed_) {
    return;
  }
  resumed_ = true;
  warnOfOtherMappers();  // that started at the same time
  next_autosave_ = ros::SteadyTime::now() + ros::WallDuration(ros_settings_.autosave_period_s);
  const std::string directory = autosaveDirectory();
  if (ros_settings_.resume_after_respawn) {
    getPrivateNodeHandle().setParam("ros/resume", true);  // for the next process
  }
  if (!ros_settings_.resume) {
    return;
  }
  if (!holdsReadings(directory)) {
    NODELET_INFO_STREAM("There is no session to resume in " << directory << "; this one is new");
    return;
  }
  try {
    const std::string added = addSession(directory);
    own_directories_.insert(directory);
    NODELET_INFO_STREAM("The session goes on: " << added);
  } catch (const std::exception& error) {
    NODELET_ERROR_STREAM("The session in "
                         << directory
                         << " cannot be resumed, and a new one starts: " << reasonOf(error));
  }
}

void MappingNodelet::autosaveIfDue() {
  if (unsaved_ && ros_settings_.autosave_period_s > 0.0 &&
      ros::SteadyTime::now() > next_autosave_) {
    next_autosave_ = ros::SteadyTime::now() + ros::WallDuration(ros_settings_.autosave_period_s);
    autosave();
  }
}

void MappingNodelet::autosave() {
  if (ros_settings_.autosave_period_s <= 0.0) {
    return;
  }
  std::string failure;
  try {
    unsaved_ = false;  // before the copy: later readings are for the next time
    const SharedMapper::Copy copy = mapper_->corrected(robots_->latestCorrections(*transforms_));
    const Session session{copy.mapper.readings(), copy.mapper.contacts(), copy.mapper.poses(),
                          copy.mapper.accessPoints()};
    if (session.readings.empty()) {
      return;
    }
    const std::string directory = autosaveDirectory();
    forgetDirectories();
    if (own_directories_.count(directory) == 0 && holdsReadings(directory)) {
      std::filesystem::rename(directory, withoutRecording(directory + "_before"));
    }
    writeSession(session, directory);
    own_directories_.insert(directory);
    const BeliefMap& belief = publishers_->last()->snapshot->belief;
    writeAtomically({{directory + "/map.pgm", trinaryPgm(belief)},
                     {directory + "/map.yaml", trinaryYaml(belief.geometry())}});
  } catch (const std::exception& error) {
    failure = reasonOf(error);
    unsaved_ = true;
  }
  const std::lock_guard<std::mutex> lock(facts_mutex_);
  facts_.autosave_failure = failure;
  if (failure.empty()) {
    announcements_.forget("autosave");
  } else if (announcements_.isNews("autosave", failure)) {
    NODELET_WARN_STREAM("The session could not be saved and will be tried again: " << failure);
  }
}

}  // namespace sfw

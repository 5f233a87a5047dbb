#include "structure_from_wifi/mapper.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "access_points/access_point_estimation.h"
#include "base/validation.h"
#include "checks/recording_checks.h"
#include "mapping/joined_radios.h"
#include "mapping/map_method.h"
#include "mapping/reading_store.h"

namespace sfw {
namespace {

std::unique_ptr<const MapMethod> makeMapMethod(const Config& config) {
  return config.method == "tomography" ? makeTomographyMethod(config)
                                       : makeKVisibilityMethod(config);
}

Eigen::ArrayXd signalsOf(const std::vector<Sample>& samples) {
  Eigen::ArrayXd rssi_dbm(static_cast<Eigen::Index>(samples.size()));
  for (std::size_t i = 0; i < samples.size(); ++i) {
    rssi_dbm[static_cast<Eigen::Index>(i)] = samples[i].rssi_dbm;
  }
  return rssi_dbm;
}

AccessPointSummary summaryOf(const AccessPoint& access_point, const std::vector<Sample>& samples) {
  AccessPointSummary summary{access_point, samples.size(), {}};
  const Eigen::ArrayXd rssi_dbm = signalsOf(samples);
  if (!samples.empty()) {
    summary.rssi_deviation_db = std::sqrt((rssi_dbm - rssi_dbm.mean()).square().mean());
  }
  return summary;
}

std::vector<AccessPointSummary> summariesOf(const std::vector<AccessPoint>& access_points,
                                            const std::vector<AccessPointReadings>& readings) {
  std::vector<AccessPointSummary> summaries;
  for (std::size_t i = 0; i < access_points.size(); ++i) {
    summaries.push_back(summaryOf(access_points[i], readings[i].samples));
  }
  return summaries;
}

/// Estimates a position that the table does not give, or gives with a standard deviation.
void estimatePosition(const std::vector<Sample>& samples, AccessPointSummary& summary) {
  AccessPoint& access_point = summary.access_point;
  if (!access_point.position_known) {
    summary.estimate = estimateAccessPoint(samples, access_point.height_m);
  } else if (access_point.position_sd_m) {
    summary.given_position = access_point.position;
    summary.estimate = estimateAccessPoint(
        samples, PositionPrior{access_point.position, *access_point.position_sd_m},
        access_point.height_m);
  }
  if (summary.estimate) {
    access_point.position = summary.estimate->position;
  }
}

/// Estimates the positions that the table does not give exactly. A BSSID gets that of its radio.
/// @param radio_of  as of JoinedRadios
/// @param readings  of radios
void estimatePositions(const std::vector<std::size_t>& radio_of,
                       const std::vector<AccessPointReadings>& readings,
                       std::vector<AccessPointSummary>& summaries, const std::atomic<bool>& stop) {
  for (std::size_t i = 0; i < summaries.size() && !stop; ++i) {
    if (radio_of[i] == i) {
      estimatePosition(readings[i].samples, summaries[i]);
    }
  }
  for (std::size_t i = 0; i < summaries.size(); ++i) {
    if (radio_of[i] != i) {
      const AccessPointSummary& radio = summaries[radio_of[i]];
      summaries[i].radio = radio.access_point.bssid;
      summaries[i].estimate = radio.estimate;
      summaries[i].given_position = radio.given_position;
      summaries[i].access_point.position = radio.access_point.position;
      summaries[i].access_point.position_known = radio.access_point.position_known;
      summaries[i].access_point.position_sd_m = radio.access_point.position_sd_m;
    }
  }
}

/// The radios, if the readings are good enough to tell.
JoinedRadios radiosOf(const std::vector<AccessPoint>& table, const RecordingFindings& findings,
                      Inliers& inliers) {
  if (findings.signal_unit || arePosesWrong(findings)) {
    JoinedRadios alone;
    alone.radio_of.resize(table.size());
    std::iota(alone.radio_of.begin(), alone.radio_of.end(), std::size_t{0});
    return alone;
  }
  return joinRadios(table, inliers);
}

/// Sets the wall count of each pose: the smallest one of its samples.
void setWallCounts(const std::vector<AccessPointReadings>& readings,
                   const std::vector<std::vector<int>>& walls, std::vector<PathPose>& path) {
  for (std::size_t i = 0; i < walls.size(); ++i) {
    for (std::size_t j = 0; j < walls[i].size(); ++j) {
      int& fewest = path[readings[i].poses[j]].walls;
      fewest = fewest == PathPose::kNoWallCount ? walls[i][j] : std::min(fewest, walls[i][j]);
    }
  }
}

}  // namespace

/// The inliers of all data, and what the checks find in all data.
struct Mapper::Checked {
  Inliers inliers;
  RecordingFindings findings;

  Checked(const ReadingStore& store, const Config& config) {
    InlierReadings kept;
    {
      const RecordingData data = store.data();
      kept = store.inliers(data.accepted);
      findings = checkRecording({data, store.accessPoints(), kept.inliers.path,
                                 kept.inliers.stamped_alike, config.path.max_gap_m});
    }  // what the checks needed makes room for the samples
    findings.frames = store.frames();
    inliers = store.withSamples(std::move(kept));
  }
};

RefreshCache::RefreshCache() : kept_(std::make_unique<KeptFeatures>()) {}
RefreshCache::RefreshCache(RefreshCache&& other) noexcept = default;
RefreshCache& RefreshCache::operator=(RefreshCache&& other) noexcept = default;
RefreshCache::~RefreshCache() = default;
bool RefreshCache::isUnfinished() const { return kept_->walls.isUnfinished(); }
void RefreshCache::clear() { *this = RefreshCache(); }

Mapper::Mapper(const Config& config, const std::vector<AccessPoint>& access_points)
    : config_(config), method_(makeMapMethod(config)) {
  throwIfAny(validate(config));
  store_ = std::make_unique<ReadingStore>(config.map, access_points);
}

Mapper::Mapper(const Mapper& other)
    : config_(other.config_),
      method_(other.method_),
      store_(std::make_unique<ReadingStore>(*other.store_)) {}

Mapper& Mapper::operator=(const Mapper& other) {
  Mapper copy(other);
  return *this = std::move(copy);
}

Mapper::Mapper(Mapper&& other) noexcept = default;
Mapper& Mapper::operator=(Mapper&& other) noexcept = default;
Mapper::~Mapper() = default;

void Mapper::configure(const Config& config) {
  throwIfAny(validate(config));
  Config taken = config;
  taken.map = config_.map;  // the readings lie on its grid
  std::shared_ptr<const MapMethod> method = makeMapMethod(taken);
  config_ = std::move(taken);
  method_ = std::move(method);
}

void Mapper::reserve(std::size_t readings) { store_->reserve(readings); }
InsertResult Mapper::insert(const Reading& reading) { return store_->insert(reading); }
InsertResult Mapper::insert(const Contact& contact) { return store_->insert(contact); }
InsertResult Mapper::insertPose(std::int64_t stamp_ns, const Position& antenna_in_map,
                                const std::string& robot) {
  return store_->insertPose(stamp_ns, antenna_in_map, robot);
}

void Mapper::recordRejected(const std::string& reason, std::size_t count) {
  store_->recordRejected(reason, count);
}

void Mapper::recordFrames(const FrameFinding& frames) { store_->recordFrames(frames); }

void Mapper::correct(const PathCorrection& correction) {
  if (!correction.empty()) {
    correct([&](std::int64_t stamp_ns, const Position& point, const std::string& robot) {
      return correction.moved(stamp_ns, point, robot);
    });
  }
}

void Mapper::correct(
    const std::function<Position(std::int64_t, const Position&, const std::string&)>& moved) {
  store_->correct(moved);
}

Box Mapper::extent() const { return store_->extent(); }
void Mapper::growTo(const Box& extent) { store_->growTo(extent); }
void Mapper::reset() { store_->reset(); }
std::pair<std::size_t, std::size_t> Mapper::forget(
    const std::function<bool(std::int64_t, const Position&, const std::string&)>& test) {
  return store_->forget(test);
}
const std::vector<AccessPoint>& Mapper::accessPoints() const { return store_->accessPoints(); }
void Mapper::setAccessPoints(const std::vector<AccessPoint>& access_points) {
  store_->setAccessPoints(access_points);
}
GridGeometry Mapper::geometry() const { return store_->geometryOf(extent()); }
std::vector<Reading> Mapper::readings() const { return store_->readings(); }
const std::vector<Contact>& Mapper::contacts() const { return store_->contacts(); }
std::vector<PathPose> Mapper::poses() const { return store_->poses(); }
const Rejections& Mapper::rejections() const { return store_->rejections(); }

std::shared_ptr<const Snapshot> Mapper::infer() const {
  const std::atomic<bool> never{false};
  return infer(never);
}

std::shared_ptr<const Snapshot> Mapper::infer(const std::atomic<bool>& stop) const {
  return mapOf({*store_, config_}, UseRadio::kYes, stop, nullptr);
}

std::shared_ptr<const Snapshot> Mapper::refresh(RefreshCache& cache,
                                                const std::atomic<bool>& stop) const {
  if (cache.method_ != method_) {  // it holds the settings
    cache.clear();
    cache.method_ = method_;
  }
  return mapOf({*store_, config_}, UseRadio::kYes, stop, cache.kept_.get());
}

std::shared_ptr<const Snapshot> Mapper::inferLast(const std::atomic<bool>& stop) {
  Checked data(*store_, config_);
  store_->drop();
  return mapOf(std::move(data), UseRadio::kYes, stop, nullptr);
}

std::shared_ptr<const Snapshot> Mapper::inferWithoutRadio() const {
  const std::atomic<bool> never{false};
  return mapOf({*store_, config_}, UseRadio::kNo, never, nullptr);
}

std::shared_ptr<const Snapshot> Mapper::mapOf(Checked data, UseRadio use_radio,
                                              const std::atomic<bool>& stop,
                                              KeptFeatures* kept) const {
  Inliers& inliers = data.inliers;
  RecordingFindings& findings = data.findings;
  removeSentinels(findings.sentinels, store_->accessPoints(), inliers.readings);
  if (findings.cached) {
    removeRepeated(inliers.readings);
  }
  // At a touch the contact lies at the edge of the footprint, so half of its radius is clearly
  // over.
  removeDrivenOver(inliers.path, 0.5 * config_.path.footprint_radius_m, config_.path.max_gap_m,
                   inliers.contacts);
  const Box extent = store_->extentOf(inliers);
  const GridGeometry geometry = store_->geometryOf(extent);
  std::vector<AccessPointSummary> access_points =
      summariesOf(store_->accessPoints(), inliers.readings);
  const JoinedRadios radios = radiosOf(store_->accessPoints(), findings, inliers);
  findings.aliases.groups = radios.groups;
  estimatePositions(radios.radio_of, inliers.readings, access_points, stop);
  MethodResult result = method_->infer(geometry, inliers, access_points, use_radio, stop, kept);
  if (stop) {
    return nullptr;
  }
  setWallCounts(inliers.readings, result.walls, inliers.path);
  const std::vector<std::size_t> heard = store_->heard();
  for (std::size_t i = 0; i < access_points.size(); ++i) {
    if (i < result.wall_counts.size()) {
      access_points[i].wall_counts = std::move(result.wall_counts[i]);
    }
    access_points[i].samples = std::move(inliers.readings[i].samples);
    access_points[i].heard = heard[i];
  }
  return std::make_shared<const Snapshot>(Snapshot{
      BeliefMap(result.occupied, config_.belief), BeliefMap(result.probability, config_.belief),
      std::move(inliers.path), std::move(access_points), store_->rejections(),
      std::move(result.tomography), inliers.stray, inliers.motion, inliers.stamped_alike, extent,
      std::move(result.wall_segments), !store_->isOpen(), std::move(findings),
      std::move(inliers.contacts)});
}

}  // namespace sfw

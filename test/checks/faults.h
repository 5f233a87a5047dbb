#pragma once

#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "base/random.h"
#include "checks/recordings.h"

namespace sfw::test {

/// A fault, and words of the one note that must name it.
struct Fault {
  std::string name;
  std::function<void(Recording&)> inject;
  std::string words;
};

using Change = std::function<void(Reading&)>;

inline std::function<void(Recording&)> each(const Change& change) {
  return [change](Recording& recording) {
    for (Reading& reading : recording.readings) {
      change(reading);
    }
  };
}

/// Seconds since the first reading.
inline double timeOf(const Recording& recording, const Reading& reading) {
  return 1e-9 * static_cast<double>(reading.stamp_ns - recording.readings.front().stamp_ns);
}

inline void removePositions(Recording& recording) {
  for (AccessPoint& access_point : recording.table) {
    access_point.position_known = false;
  }
}

inline std::function<void(Recording&)> scaled(double scale, bool with_positions) {
  return [=](Recording& recording) {
    each([&](Reading& reading) { reading.antenna_in_map *= scale; })(recording);
    for (AccessPoint& access_point : recording.table) {
      access_point.position *= scale;
    }
    if (!with_positions) {
      removePositions(recording);
    }
  };
}

inline std::function<void(Recording&)> timed(double scale) {
  return [=](Recording& recording) {
    const std::int64_t start = recording.readings.front().stamp_ns;
    each([&](Reading& reading) {
      reading.stamp_ns = std::llround(scale * static_cast<double>(reading.stamp_ns - start));
    })(recording);
  };
}

inline std::function<void(Recording&)> notHeardAs(double value, double share) {
  return [=](Recording& recording) {
    Random random(1, 2, 3);
    each([&](Reading& reading) {
      reading.rssi_dbm = random.uniform() < share ? value : reading.rssi_dbm;
    })(recording);
  };
}

inline std::function<void(Recording&)> stampsRoundedTo(std::int64_t seconds) {
  return each([=](Reading& reading) {
    const std::int64_t step = seconds * 1000000000;
    reading.stamp_ns = reading.stamp_ns / step * step;
  });
}

inline std::function<void(Recording&)> repeated(int times) {
  return [=](Recording& recording) {
    std::map<Bssid, std::pair<int, double>> last;
    each([&](Reading& reading) {
      auto& [count, value] = last[reading.bssid];
      value = count++ % times == 0 ? reading.rssi_dbm : value;
      reading.rssi_dbm = value;
    })(recording);
  };
}

/// Changes the readings of the second half of the drive.
inline std::function<void(Recording&)> halfway(const Change& change) {
  return [change](Recording& recording) {
    for (std::size_t i = recording.readings.size() / 2; i < recording.readings.size(); ++i) {
      change(recording.readings[i]);
    }
  };
}

inline std::function<void(Recording&)> only(
    const std::function<bool(const Recording&, const Reading&)>& is_kept) {
  return [is_kept](Recording& recording) {
    const Recording whole = recording;
    recording.readings.clear();
    for (const Reading& reading : whole.readings) {
      if (is_kept(whole, reading)) {
        recording.readings.push_back(reading);
      }
    }
  };
}

/// Delivers the readings of each four seconds at once, with the position of then.
inline void deliverInBursts(Recording& recording) {
  constexpr std::int64_t kPeriod = 4000000000;
  constexpr std::int64_t kApart = 5000000;
  const Recording whole = recording;
  std::size_t at = 0;
  std::int64_t in_burst = 0;
  std::int64_t last_end = 0;
  for (Reading& reading : recording.readings) {
    const std::int64_t end = (reading.stamp_ns / kPeriod + 1) * kPeriod;
    while (at + 1 < whole.readings.size() && whole.readings[at].stamp_ns < end) {
      ++at;
    }
    in_burst = end == last_end ? in_burst + 1 : 0;
    last_end = end;
    reading.stamp_ns = end + kApart * in_burst;
    reading.antenna_in_map = whole.readings[at].antenna_in_map;
  }
}

inline std::function<void(Recording&)> withAlias(double noise_db) {
  return [=](Recording& recording) {
    Random random(4, 5, 6);
    recording.table.push_back(recording.table.front());
    recording.table.back().bssid = bssid(0x77);
    const Recording whole = recording;
    for (Reading reading : whole.readings) {
      if (reading.bssid == recording.table.front().bssid) {
        reading.bssid = bssid(0x77);
        reading.rssi_dbm += std::round(noise_db * random.normal());
        recording.readings.push_back(reading);
      }
    }
  };
}

inline std::function<void(Recording&)> withSilent(int count) {
  return [=](Recording& recording) {
    for (int i = 0; i < count; ++i) {
      recording.table.push_back(accessPoint(100 + i, 1.0, 1.0));
    }
  };
}

inline void hearAtOnePlace(Recording& recording) {
  recording.table.push_back(accessPoint(0x78, 2.0, 2.0));
  for (std::size_t i = 0; i < 10; ++i) {
    Reading reading = recording.readings[2 * i];
    reading.antenna_in_map = recording.readings.front().antenna_in_map;
    reading.bssid = bssid(0x78);
    reading.rssi_dbm = -70.0 - static_cast<double>(i % 3);
    recording.readings.push_back(reading);
  }
}

inline void moveAccessPoints(Recording& recording) {
  Box driven;
  for (const Reading& reading : recording.readings) {
    driven.extend(reading.antenna_in_map);
  }
  for (AccessPoint& access_point : recording.table) {  // to the other side of the building
    access_point.position = driven.min() + driven.max() - access_point.position;
  }
}

/// All faults that the checks of a recording tell apart.
inline std::vector<Fault> allFaults() {
  const auto percent = [](Reading& reading) {
    reading.rssi_dbm = std::min(100.0, 2.0 * (reading.rssi_dbm + 100.0));
  };
  const auto without_positions = [](const std::function<void(Recording&)>& inject) {
    return [inject](Recording& recording) {
      inject(recording);
      removePositions(recording);
    };
  };
  const std::string not_heard = "stands for 'not heard'";
  std::vector<Fault> faults{
      {"centimetres", scaled(100.0, true), "look like centimetres"},
      {"centimetres, no positions", scaled(100.0, false), "look like centimetres"},
      {"millimetres", scaled(1000.0, false), "look like millimetres"},
      {"pixels of 5 cm", scaled(20.0, true), "look like pixels"},
      {"pixels of 5 cm, no positions", scaled(20.0, false), "look like pixels"},
      {"milliseconds", timed(1e3), "look like milliseconds"},
      {"microseconds", timed(1e6), "look like microseconds"},
      {"minutes", timed(1.0 / 60.0), "look like minutes"},
      {"days", timed(1.0 / 86400.0), "look like days"},
      {"percent", each(percent), "look like percent or another quality"},
      {"percent, no positions", without_positions(each(percent)), "look like percent (convert"},
      {"no minus sign", each([](Reading& r) { r.rssi_dbm = -r.rssi_dbm; }), "minus sign"},
      {"tenths", each([](Reading& r) { r.rssi_dbm *= 10.0; }), "tenths of dBm"},
      {"mBm", each([](Reading& r) { r.rssi_dbm *= 100.0; }), "look like mBm"},
      {"bytes", each([](Reading& r) { r.rssi_dbm += 256.0; }), "look like unsigned bytes"},
      {"one stamp", each([](Reading& r) { r.stamp_ns = 1600000000000000000; }), "the same stamp,"},
      {"stamps of 1 s", stampsRoundedTo(1), "stamps are rounded"},
      {"stamps of 100 s", stampsRoundedTo(100), "stamps are rounded"},
      {"clock set back", halfway([](Reading& r) { r.stamp_ns -= 33370000000; }), "step back by"},
      {"cached, 2 times", repeated(2), "repeats old scans"},
      {"cached, 20 times", repeated(20), "repeats old scans"},
      {"bursts", deliverInBursts, "come in bursts"},
      {"two publishers", each([](Reading& r) {
         r.antenna_in_map.x() += r.stamp_ns / 200000000 % 2 == 0 ? 0.0 : 5.0;
       }),
       "two programs that publish"},
      {"missing frame",
       [](Recording& r) {
         r.readings.clear();
         r.frames.missing = "odom";
         r.frames.lost = 40;
       },
       "no transform has the frame 'odom'"},
      {"flipping transform",
       [](Recording& r) {
         r.frames.published_twice = "map to odom";
         r.frames.flips = 30;
       },
       "two programs publish it"},
      {"two floors",
       [](Recording& r) {
         r.frames.floors_m = {0.2, 3.1};
       },
       "drives on 2 floors"},
      {"a scan each 4 s", only([](const Recording& whole, const Reading& reading) {
         return std::fmod(timeOf(whole, reading) + 1e-6, 4.0) < 0.1;
       }),
       "longer than path/max_gap"},
      {"a short drive", only([](const Recording& whole, const Reading& reading) {
         return timeOf(whole, reading) < 0.9;
       }),
       "hardly moved"},
      {"few readings", only([](const Recording& whole, const Reading& reading) {
         return std::fmod(timeOf(whole, reading) + 1e-6, 40.0) < 0.1;
       }),
       "too few to find walls"},
      {"a localisation lost",
       [](Recording& recording) {
         const Recording whole = recording;
         each([&](Reading& r) {
           r.antenna_in_map.x() += std::abs(timeOf(whole, r) - 30.0) < 1.5 ? 60.0 : 0.0;
         })(recording);
       },
       "poses are left out"},
      {"a jump", halfway([](Reading& r) { r.antenna_in_map.x() += 20.0; }),
       "the path jumps 1 time"},
      {"never heard", withSilent(1), "access points of the table have no reading"},
      {"20 never heard", withSilent(20), "20 of "},
      {"one radio", withAlias(0.0), "under several BSSIDs"},
      {"one radio, noise", withAlias(1.0), "under several BSSIDs"},
      {"heard at one place", hearAtOnePlace, "heard at one place only"},
      {"wrong positions", moveAccessPoints, "much better than the given one"},
      {"a table in decimetres",
       [](Recording& recording) {
         for (AccessPoint& access_point : recording.table) {
           access_point.position *= 10.0;
         }
       },
       "are in metres and in the same frame"},
  };
  for (const double value : {-1.0, 0.0, -95.0, -100.0, -105.0, -110.0, -119.0, -127.0, 100.0}) {
    for (const double share : {0.05, 0.3}) {
      faults.push_back(
          {"not heard as " + std::to_string(value), notHeardAs(value, share), not_heard});
    }
  }
  return faults;
}

}  // namespace sfw::test

// Messages of the kernel's nl80211.

#include <cmath>

#include "fuzz_target.h"
#include "wireless/nl80211_messages.h"
#include "wireless/simulated_kernel.h"

namespace sfw::fuzz {
namespace {

std::string textOf(const Bytes& bytes) { return {bytes.begin(), bytes.end()}; }

}  // namespace

std::vector<std::string> seeds() {
  test::KernelState::Network network;
  network.bssid = {2, 0, 0, 0, 0, 1};
  network.heard_boot_ns = 1'000'000'000;
  network.is_associated = true;
  network.multi_link = test::Address{2, 0, 0, 0, 0, 9};
  test::KernelState::Network without_unit;
  without_unit.has_unit = false;
  test::KernelState::Station station;
  station.link_signals_dbm = {{0, -50}, {1, -60}};
  return {
      textOf(test::familyMessage(1)),
      textOf(test::interfaceMessage({}, 2)) + textOf(test::endMessage(NLMSG_DONE, 2, 0)),
      textOf(test::networkMessage(network, 3)) + textOf(test::networkMessage(without_unit, 3)),
      textOf(test::stationMessage(station, 4)),
      textOf(test::eventMessage(NL80211_CMD_NEW_SCAN_RESULTS)),
      textOf(test::endMessage(NLMSG_ERROR, 5, 1)),
  };
}

void feed(std::string_view input) {
  // Copies of their exact size: a sanitizer sees each byte that is read beyond the end.
  for (const Bytes& message : splitMessages(Bytes(input.begin(), input.end()))) {
    parseHeader(message);
    parseFamily(message);
    parseInterface(message);
    parseScanEvent(message);
    if (const auto network = parseNetwork(message)) {
      require(!network->rssi_dbm || std::isfinite(*network->rssi_dbm));
      require(network->age_s >= 0.0);
    }
    if (const auto station = parseStation(message)) {
      require(station->inactive_s >= 0.0);
    }
  }
}

}  // namespace sfw::fuzz

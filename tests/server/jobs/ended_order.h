#pragma once

#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include "server/jobs/on_demand.h"

namespace toile::test {

/// How what was asked for stands once it is neither waiting nor being made; nameless after 20 s.
inline jobs::Order ended_order(jobs::OnDemand& made, const store::RequestContext& owner,
                               const std::string& job, const std::string& name) {
  for (int waited = 0; waited < 2000; ++waited) {
    const std::vector<jobs::Order> told = made.of_job(owner, job).value();
    for (const jobs::Order& order : told) {
      const bool over = order.state == jobs::OrderState::kMade || order.state == jobs::OrderState::kFailed;
      if (order.name == name && over) return order;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return {};
}

}  // namespace toile::test

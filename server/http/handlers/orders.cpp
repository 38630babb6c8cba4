#include "server/http/handlers/orders.h"

#include <cmath>
#include <utility>
#include <vector>

#include "server/http/problem.h"

namespace toile::handlers {
namespace {

json::JsonValue order_json(const std::string& job, const jobs::Order& order) {
  json::JsonValue href, error;
  if (order.state == jobs::OrderState::kMade)
    href = json::JsonValue("/api/v1/jobs/" + job + "/results/" + order.name);
  if (order.error) {
    error = json::JsonValue(
        std::vector<json::JsonMember>{{"code", order.error->code}, {"detail", order.error->message}});
  }
  return std::vector<json::JsonMember>{{"name", order.name},
                                       {"state", std::string(jobs::word_of(order.state))},
                                       {"fraction", order.fraction},
                                       {"href", std::move(href)},
                                       {"error", std::move(error)}};
}

}  // namespace

Status read_whole(const json::JsonValue& given, const char* key, const char* code, int& into) {
  const json::JsonValue* value = given.find(key);
  if (!value) return {};
  const double* number = value->number();
  if (!number || std::floor(*number) != *number || std::abs(*number) > 1e6) {
    return Error{code, "\"" + std::string(key) + "\" is a whole number", "/" + std::string(key)};
  }
  into = static_cast<int>(*number);
  return {};
}

std::string word_in(const json::JsonValue& given, const char* key, const char* usual) {
  const json::JsonValue* value = given.find(key);
  if (!value) return usual;
  return value->text() ? *value->text() : "";
}

http::HttpResponse order_answer(const std::string& job, const char* thing, const Result<jobs::Order>& order) {
  if (!order) return http::problem(order.error());
  const int status = order->state == jobs::OrderState::kMade ? 200 : 202;
  return json_answer(status, {{thing, order_json(job, *order)}});
}

http::HttpResponse orders_answer(jobs::OnDemand& made, const char* things,
                                 const store::RequestContext& context, const http::HttpRequest& request) {
  const std::string& job = request.captures[0];
  const Result<std::vector<jobs::Order>> orders = made.of_job(context, job);
  if (!orders) return http::problem(orders.error());
  std::vector<json::JsonValue> items;
  for (const jobs::Order& order : *orders) items.push_back(order_json(job, order));
  return json_answer(200, {{things, std::move(items)}});
}

http::HttpResponse cancel_order(jobs::OnDemand& made, const store::RequestContext& context,
                                const http::HttpRequest& request) {
  const Status cancelled = made.cancel(context, request.captures[0], request.captures[1]);
  return cancelled ? no_content() : http::problem(cancelled.error());
}

}  // namespace toile::handlers

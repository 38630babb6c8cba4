#pragma once
// Results of a drape that are made on demand, as answers: movies and stills are asked for, listed and taken
// back alike.

#include <string>

#include "server/http/handlers/answer.h"
#include "server/http/handlers/api.h"
#include "server/jobs/on_demand.h"

namespace toile::handlers {

/// A whole number of the request's, where it is given. Error: `code`.
Status read_whole(const json::JsonValue& given, const char* key, const char* code, int& into);
/// The text of that key, or `usual`; "" where it is no text, which nothing is called.
std::string word_in(const json::JsonValue& given, const char* key, const char* usual);

/// 200 once it is made, 202 before; `thing` names it in the answer.
http::HttpResponse order_answer(const std::string& job, const char* thing, const Result<jobs::Order>& order);
http::HttpResponse orders_answer(jobs::OnDemand& made, const char* things,
                                 const store::RequestContext& context, const http::HttpRequest& request);
http::HttpResponse cancel_order(jobs::OnDemand& made, const store::RequestContext& context,
                                const http::HttpRequest& request);

}  // namespace toile::handlers

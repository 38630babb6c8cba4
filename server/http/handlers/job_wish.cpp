#include "server/http/handlers/job_wish.h"

#include "server/http/handlers/job_tags.h"

namespace toile::handlers {

Result<jobs::JobWish> read_job_wish(const json::JsonValue& given) {
  jobs::JobWish wish;
  if (const json::JsonValue* word = given.find("priority")) {
    const Result<store::JobPriority> priority = store::job_priority_from(word->text() ? *word->text() : "");
    if (!priority) return Error{"request.priority", priority.error().message, "/priority"};
    wish.priority = *priority;
  }
  if (const json::JsonValue* pictures = given.find("pictures")) {
    if (!pictures->boolean()) return Error{"request.pictures", "\"pictures\" is true or false", "/pictures"};
    wish.pictures = *pictures->boolean();
  }
  if (const json::JsonValue* anew = given.find("anew")) {
    if (!anew->boolean()) return Error{"request.anew", "\"anew\" is true or false", "/anew"};
    wish.anew = *anew->boolean();
  }
  if (const json::JsonValue* from = given.find("from")) {
    if (!from->text()) return Error{"request.from", "\"from\" is the id of a job", "/from"};
    wish.from = *from->text();
  }
  wish.tags = TRY(read_tags(given));
  return wish;
}

}  // namespace toile::handlers

/// How pages look.
#pragma once

namespace crawford::reports::page {

/// The style sheet of the report.
extern const char* const style;

}  // namespace crawford::reports::page

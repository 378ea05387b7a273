#include "base/work_done.hpp"

namespace crawford {

WorkDone& work_of_this_thread() {
    static thread_local WorkDone done;
    return done;
}

}  // namespace crawford

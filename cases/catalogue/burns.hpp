/// Burns that several cases look at, each made once.
#pragma once

#include <exception>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "solver/scene/write_scene.hpp"

namespace crawford {

/// What burns leave, by the text of their scenes. Safe to ask from several threads.
template <class Result>
class Burns {
public:
    using Made = std::shared_ptr<const Result>;

    /// The result of an equal scene; who asks first makes it, `make()` -> Made, who asks while it
    /// is under way waits.
    /// \throws what `make` threw, to everybody who asks.
    template <class Make>
    Made get(const Scene& scene, const Make& make) {
        std::promise<Made> promise;
        std::shared_future<Made> made;
        bool mine = false;
        {
            const std::scoped_lock lock(mutex_);
            auto [place, is_new] = burns_.try_emplace(to_toml(scene));
            if (is_new) place->second = promise.get_future().share();
            made = place->second;
            mine = is_new;
        }
        if (mine) {
            try {
                promise.set_value(make());
            } catch (...) {
                promise.set_exception(std::current_exception());
            }
        }
        return made.get();
    }

private:
    std::mutex mutex_;
    std::map<std::string, std::shared_future<Made>> burns_;
};

}  // namespace crawford

#include "program/movie.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/errors.hpp"
#include "program/choose.hpp"

namespace crawford {

namespace {

std::vector<std::string> filmed_cases() {
    std::vector<std::string> names;
    for (const Entry& entry : catalogue())
        if (entry.draw_movie) names.push_back(entry.name);
    return names;
}

}  // namespace

std::string movie_name(const Entry& entry) {
    return entry.name + "_movie";
}

std::vector<Entry> choose_movies(const std::vector<std::string>& names) {
    std::vector<Entry> movies;
    for (const Entry* entry : choose_cases(names.empty() ? filmed_cases() : names)) {
        if (!entry->draw_movie)
            throw InputError(fmt::format("--movie: {} has no movie; {} has", entry->name,
                                         fmt::join(filmed_cases(), ", ")));
        Entry movie = *entry;
        movie.name = movie_name(*entry);
        movie.draw = entry->draw_movie;
        movie.burns = entry->movie_burns;
        movies.push_back(movie);
    }
    return movies;
}

}  // namespace crawford

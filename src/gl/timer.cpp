#include "gl/timer.hpp"

#include "gl/driver.hpp"

namespace sunder::gl {

void deleteQuery(GLuint id) {
    if (Driver::current()) glDeleteQueries(1, &id);
}

Query makeQuery() {
    GLuint id = 0;
    glGenQueries(1, &id);
    return Query(id);
}

void Timer::begin() {
    if (used_ == queries_.size()) queries_.push_back(makeQuery());
    glBeginQuery(GL_TIME_ELAPSED, queries_[used_++].id());
}

void Timer::end() {
    glEndQuery(GL_TIME_ELAPSED);
}

std::vector<double> Timer::take() {
    std::vector<double> milliseconds;
    for (std::size_t i = 0; i < used_; ++i) {
        GLuint64 nanoseconds = 0;
        glGetQueryObjectui64v(queries_[i].id(), GL_QUERY_RESULT, &nanoseconds);
        milliseconds.push_back(static_cast<double>(nanoseconds) * 1e-6);
    }
    used_ = 0;
    return milliseconds;
}

}  // namespace sunder::gl

#pragma once

namespace sunder {

/// A host's threads. Both functions are called on the thread that calls the world; the tasks they
/// get may run on any thread. The bits of a result do not depend on them. Neither may throw.
struct TaskSystem {
    void* user = nullptr;  ///< Handed to both functions.
    /// How many tasks may run at once, 1 to 1024. Asked as a world is made.
    int (*concurrency)(void* user) = nullptr;
    /// Calls task(data, 0) to task(data, count − 1), each once, in any order, on any threads, and
    /// returns when all of them have returned. It is called again from within a task. Tasks may
    /// last as long as the call that they serve: they share its passes out among those that run.
    void (*forEach)(void* user, int count, void (*task)(void* data, int index),
                    void* data) = nullptr;
};

}  // namespace sunder

#pragma once
#include <string>
#include <utility>
#include <variant>

namespace sunder {

/// A place, a direction or three sizes along x, y, z. Right-handed; y is up.
struct Vec3 {
    double x = 0;  ///< To the right.
    double y = 0;  ///< Upwards.
    double z = 0;  ///< Towards the viewer.
    /// Whether all three numbers are equal.
    friend bool operator==(const Vec3&, const Vec3&) = default;
};

/// Whole numbers along x, y, z.
struct IVec3 {
    int x = 0;  ///< Along x.
    int y = 0;  ///< Along y.
    int z = 0;  ///< Along z.
    /// Whether all three numbers are equal.
    friend bool operator==(const IVec3&, const IVec3&) = default;
};

/// A rotation as a unit quaternion; as it is made, none. Where a function takes one, its length
/// must be 1 within 1e-3; it is then made exactly 1.
struct Quat {
    double w = 1;  ///< Cosine of half the angle.
    double x = 0;  ///< Sine of half the angle, times the axis.
    double y = 0;  ///< Likewise.
    double z = 0;  ///< Likewise.
    /// Whether all four numbers are equal. A rotation has two quaternions.
    friend bool operator==(const Quat&, const Quat&) = default;
};

/// Where something is and how it is turned.
struct Transform {
    Vec3 position{};     ///< m, world.
    Quat orientation{};  ///< From its own axes to the world's.
};

/// Why something did not happen.
struct Error {
    /// What kind of reason it is.
    enum class Code {
        Input = 1,   ///< What was asked for makes no sense: the message says what and why.
        Memory = 2,  ///< There is not enough memory, of the machine or of the GPU.
        Device = 3,  ///< The GL context is too old or lost, or its driver failed.
        Bug = 4,     ///< A fault of Sunder's: please report the message.
    };
    Code code = Code::Input;  ///< What kind of reason it is.
    std::string message{};    ///< One sentence, in UTF-8, without a full stop.
};

/// What a function returns that may fail: a value, or an Error. No function of Sunder throws.
template <class T>
class [[nodiscard]] Result {
  public:
    /// A value.
    Result(T value) : content_(std::move(value)) {}
    /// A failure.
    Result(Error error) : content_(std::move(error)) {}

    /// Whether there is a value.
    explicit operator bool() const noexcept { return content_.index() == 0; }
    /// The value. There must be one.
    T& operator*() noexcept { return *std::get_if<0>(&content_); }
    /// The value. There must be one.
    const T& operator*() const noexcept { return *std::get_if<0>(&content_); }
    /// The value. There must be one.
    T* operator->() noexcept { return std::get_if<0>(&content_); }
    /// The value. There must be one.
    const T* operator->() const noexcept { return std::get_if<0>(&content_); }
    /// Why there is no value. There must be none.
    const Error& error() const noexcept { return *std::get_if<1>(&content_); }

  private:
    std::variant<T, Error> content_;
};

/// What a function returns that may fail and has nothing to give. It may be ignored: whatever fails
/// leaves everything as it was.
template <>
class Result<void> {
  public:
    /// Success.
    Result() = default;
    /// A failure.
    Result(Error error) : error_(std::move(error)), failed_(true) {}

    /// Whether it went well.
    explicit operator bool() const noexcept { return !failed_; }
    /// Why it did not. It must have failed.
    const Error& error() const noexcept { return error_; }

  private:
    Error error_;
    bool failed_ = false;
};

}  // namespace sunder

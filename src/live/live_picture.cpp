// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "live/live_picture.hpp"

#include <algorithm>
#include <utility>

#include "balcony/denoise.hpp"

namespace balcony::live {

namespace {

std::shared_ptr<render::Film> film_of(const render::FilmLayout& layout, Diagnostics& found) {
    Result<render::Film> film = render::make_film(layout);
    if (!film) {
        found = std::move(film.diagnostics);
        return nullptr;
    }
    return std::make_shared<render::Film>(std::move(*film));
}

}  // namespace

bool MovingJob::take(Result<render::Job> made, Diagnostics& found) {
    found.insert(found.end(), made.diagnostics.begin(), made.diagnostics.end());
    job_ = std::move(made.value);
    return job_.has_value();
}

bool MovingJob::make(const render::Renderer& renderer, const camera::Picture& picture,
                     const render::Settings& settings, const render::FilmLayout& layout,
                     const std::stop_token& stop, Diagnostics& found) {
    const bool has_size = job_ && film().width == layout.width && film().height == layout.height;
    if (has_size && !has_expired_) {
        return true;
    }
    has_expired_ = false;
    std::shared_ptr<render::Film> film = film_of(layout, found);
    return film &&
           take(has_size ? job_->again(renderer, settings, std::move(film), stop)
                         : render::Job::make(renderer, picture, settings, std::move(film), stop),
                found);
}

Diagnostics MovingJob::move(std::span<const camera::KnownInput> inputs) {
    return job_ ? job_->set_inputs(inputs) : Diagnostics();
}

bool MovingJob::run(std::size_t samples, const std::stop_token& stop, Diagnostics& found) {
    const std::vector<std::uint32_t> passes(film().passes.size(),
                                            static_cast<std::uint32_t>(samples));
    const Result<render::Summary> summary = job_->run(passes, {}, stop);
    found.insert(found.end(), summary.diagnostics.begin(), summary.diagnostics.end());
    return summary && !summary->interrupted;
}

namespace {

const lang::OpenParameter* find(const std::vector<lang::OpenParameter>& all,
                                std::string_view name) {
    const auto at = std::find_if(all.begin(), all.end(),
                                 [&](const lang::OpenParameter& one) { return one.name == name; });
    return at == all.end() ? nullptr : &*at;
}

}  // namespace

void LivePicture::move(const std::vector<Value>& values, Diagnostics& found) {
    inputs_.clear();
    for (const lang::OpenParameter& one : opened_.open) {
        const auto wanted = std::find_if(values.begin(), values.end(), [&](const Value& value) {
            return value.parameter == one.name;
        });
        inputs_.push_back(
            {lang::parameter_input(one.name), wanted == values.end() ? one.value : wanted->value});
    }
    for (MovingJob* const job : {&coarse_, &preview_, &paths_}) {
        const Diagnostics wrong = job->move(inputs_);
        found.insert(found.end(), wrong.begin(), wrong.end());
    }
}

void LivePicture::expire() {
    for (MovingJob* const job : {&coarse_, &preview_, &paths_}) {
        job->expire();
    }
}

Dragged LivePicture::drag(const Drag& drag, const std::vector<Value>& values, double time,
                          Axes axes, const std::stop_token& stop) {
    if (!dragger_ || dragged_layer_ != drag.layer || dragged_time_ != time) {
        Result<Dragger> made = Dragger::make(opened_, drag.layer, size_, time, stop);
        dragger_ = std::move(made.value);
        dragged_layer_ = drag.layer;
        dragged_time_ = time;
        if (!dragger_) {
            Dragged none;
            none.points.resize(drag.pulls.size());
            none.diagnostics = std::move(made.diagnostics);
            return none;
        }
    }
    return dragger_->drag(drag, values, axes, stop);
}

bool LivePicture::is_open(const std::string& parameter) const {
    return find(opened_.open, parameter) != nullptr;
}

bool LivePicture::is_angle(const std::string& parameter) const {
    for (const std::vector<lang::OpenParameter>* const some : {&opened_.open, &opened_.numbers}) {
        if (const lang::OpenParameter* const one = find(*some, parameter)) {
            return one->is_angle;
        }
    }
    return std::any_of(opened_.moving.begin(), opened_.moving.end(), [&](const auto& one) {
        return one.number.name == parameter && one.number.is_angle;
    });
}

std::vector<lang::Override> LivePicture::all_closed(const std::vector<Value>& values) const {
    std::vector<lang::Override> closed;
    for (const Value& value : values) {
        closed.push_back({value.parameter, lang::literal(value.value, is_angle(value.parameter))});
    }
    return closed;
}

render::Settings LivePicture::with_inputs(render::Settings settings) const {
    settings.inputs = inputs_;
    return settings;
}

const render::Film* LivePicture::preview(const app::PreparedScene& scene, std::size_t part,
                                         const std::stop_token& stop, Diagnostics& found) {
    const std::size_t width = std::max<std::size_t>(size_[0] / part, 1);
    const std::size_t height = std::max<std::size_t>(size_[1] / part, 1);
    MovingJob& job = part > 1 ? coarse_ : preview_;
    const bool is_made =
        job.make(scene.renderer(), opened_.picture, preview_settings(scene),
                 {.width = width, .height = height, .data_layers = false}, stop, found);
    return is_made && job.run(1, stop, found) ? &job.film() : nullptr;
}

render::Settings LivePicture::preview_settings(const app::PreparedScene& scene) const {
    render::Settings settings = with_inputs(scene.settings());
    settings.integrator = "preview";
    settings.samples = 1;
    settings.sampling.noise = 0.0;
    return settings;
}

const render::Film* LivePicture::data(const app::PreparedScene& scene, const render::Region& window,
                                      const std::stop_token& stop, Diagnostics& found) {
    using render::LayerId;
    render::Settings settings = preview_settings(scene);
    settings.ambient = render::Color3f(1.0F);  // None is to be chosen for what shows no light.
    const render::FilmLayout layout{
        .width = size_[0],
        .height = size_[1],
        .window = window,
        .data_layers = false,
        .layers = {LayerId::ray_length, LayerId::position, LayerId::normal, LayerId::object,
                   LayerId::origin, LayerId::direction, LayerId::parameters, LayerId::valid,
                   LayerId::picture_layer, LayerId::magnification, LayerId::crypto_material}};
    data_.expire();
    const bool is_made =
        data_.make(scene.renderer(), opened_.picture, settings, layout, stop, found);
    return is_made && data_.run(1, stop, found) ? &data_.film() : nullptr;
}

std::optional<PixelMetrics::Metric> LivePicture::metric(const app::PreparedScene& scene,
                                                        std::size_t layer, const Imath::V2d& point,
                                                        double distance,
                                                        const std::stop_token& stop) {
    if (!metrics_ || kind_of_errors(metrics_->diagnostics) == Kind::interrupted) {
        metrics_ = PixelMetrics::make(opened_, size_, stop);
    }
    return *metrics_ ? (*metrics_)->at(layer, point, distance, scene.settings().time, inputs_)
                     : std::nullopt;
}

const render::Film* LivePicture::paths(const app::PreparedScene& scene, std::size_t samples,
                                       bool will_denoise, const std::stop_token& stop,
                                       Diagnostics& found) {
    render::FilmLayout layout{.width = size_[0], .height = size_[1], .data_layers = false};
    if (will_denoise) {
        layout.layers = render::denoise_layers();
    }
    const bool is_made = paths_.make(scene.renderer(), opened_.picture,
                                     with_inputs(scene.settings()), layout, stop, found);
    return is_made && paths_.run(samples, stop, found) ? &paths_.film() : nullptr;
}

}  // namespace balcony::live

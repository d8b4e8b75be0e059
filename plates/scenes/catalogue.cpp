// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scenes/catalogue.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "balcony/names.hpp"
#include "scenes/candle/candle.hpp"
#include "scenes/chess/chess.hpp"
#include "scenes/corner/corner.hpp"
#include "scenes/dancer/dancer.hpp"
#include "scenes/gallery/gallery.hpp"
#include "scenes/kitchen_table/kitchen_table.hpp"
#include "scenes/knot/knot.hpp"
#include "scenes/lane/lane.hpp"
#include "scenes/marbles/marbles.hpp"
#include "scenes/plant/plant.hpp"
#include "scenes/print_gallery/print_gallery.hpp"
#include "scenes/room/room.hpp"
#include "scenes/soft/soft.hpp"
#include "scenes/street/street.hpp"
#include "scenes/temple/temple.hpp"
#include "scenes/terrace/terrace.hpp"
#include "scenes/towers/towers.hpp"
#include "scenes/vase/vase.hpp"
#include "scenes/wall/wall.hpp"

namespace balcony::plates {

namespace {

constexpr std::array scenes{
    SceneRow{"candle", "a still life with a burning candle, for pictures that hang", make_candle},
    SceneRow{"chess", "the end of a game of chess, for pictures that hang", make_chess},
    SceneRow{"corner", "two walls with four pictures under spot lights (plates 9 to 11)",
             make_corner},
    SceneRow{"dancer", "a porcelain dancer on a turntable (plate 17)", make_dancer},
    SceneRow{"gallery", "a closed room with seven pictures (plates 1 to 3)", make_gallery},
    SceneRow{"kitchen_table", "a still life after Cézanne (plate 23)", make_kitchen_table},
    SceneRow{"knot", "a knotted, coloured tube, for pictures that hang", make_knot},
    SceneRow{"lane", "a lane of an old town that turns round three corners (plate 22)", make_lane},
    SceneRow{"marbles", "marbles of all colours, for pictures that hang", make_marbles},
    SceneRow{"plant", "a plant in a pot by a window: a picture of plates 9 to 11", make_plant},
    SceneRow{"print_gallery", "a gallery above a harbour, with a print of itself (plate 19)",
             make_print_gallery},
    SceneRow{"room", "a furnished living room with windows on one side", make_room},
    SceneRow{"soft", "four letters in a studio (plates 14 and 15)", make_soft},
    SceneRow{"street", "a street between two rows of houses, in autumn (plate 20)", make_street},
    SceneRow{"temple", "a round temple in the desert at evening (plates 12, 13 and 16)",
             make_temple},
    SceneRow{"terrace", "a game of chess by night, before a lane with lampions (plate 21)",
             make_terrace},
    SceneRow{"towers", "a town of coloured blocks, for pictures that hang", make_towers},
    SceneRow{"vase", "an amphora, painted all round, on a plinth (plate 18)", make_vase},
    SceneRow{"wall", "seven by seven pictures on one wall (plates 4 to 8)", make_wall},
};

}  // namespace

std::span<const SceneRow> scene_catalogue() { return scenes; }

Result<scene::Scene> make_scene(std::string_view name, const SceneOptions& options) {
    const auto row = std::find_if(scenes.begin(), scenes.end(),
                                  [&](const SceneRow& scene) { return scene.name == name; });
    if (row == scenes.end()) {
        std::vector<std::string> names;
        for (const SceneRow& scene : scenes) {
            names.emplace_back(scene.name);
        }
        return error(fmt::format("there is no scene '{}'", name), {},
                     suggestion(name, names, "the scenes are"));
    }
    return row->make(options);
}

}  // namespace balcony::plates

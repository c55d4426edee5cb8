package enlightenment.importer.gltf;

import enlightenment.importer.support.Affine;
import java.util.List;
import java.util.function.Function;
import java.util.stream.Stream;

/**
 * Maps from a node's coordinates to those of the scene at frames of the film. Between two of them the numbers that a node carries change linearly.
 *
 * @param start the map at frame 0
 * @param frames the frames, increasing; none for a node that stands
 * @param maps the map at each of them
 */
record NodePoses(Affine start, int[] frames, List<Affine> maps) {
    /** The poses of a node that stands. */
    static NodePoses standing(Affine map) {
        return new NodePoses(map, new int[0], List.of());
    }

    /** All maps, that of frame 0 first. */
    List<Affine> all() {
        return Stream.concat(Stream.of(start), maps.stream()).toList();
    }

    /** Numbers that depend on the map, at the frames of the poses. */
    SampledProperty carried(Function<Affine, double[]> numbers) {
        return new SampledProperty(frames, maps.stream().map(numbers).toList());
    }
}

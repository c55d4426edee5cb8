package enlightenment.importer.gltf;

import enlightenment.importer.support.Affine;
import java.util.List;
import java.util.Optional;
import java.util.TreeSet;
import java.util.stream.IntStream;

/**
 * The moving nodes that a node lies in, itself among them, from the inside outwards.
 *
 * @param motions of each moving node
 * @param standing the maps between them: the first leads from the coordinates of the innermost node to those that the first motion moves, the last
 *     to the scene; one more than there are motions
 */
record NodeChain(List<NodeMotions.Motion> motions, List<Affine> standing) {
    /** The map from the innermost node to the scene at a time in seconds. */
    Affine at(double time) {
        Affine map = standing.get(0);
        for (int i = 0; i < motions.size(); i++) {
            map = standing.get(i + 1).after(motions.get(i).at(time).affine()).after(map);
        }
        return map;
    }

    /** Frames between which the map changes linearly, up to less than a frame: those of the keys where all nodes are moved along straight lines alone, else all. */
    int[] frames(NodeMotions film) {
        double rate = film.framesPerSecond();
        TreeSet<Integer> ofKeys = new TreeSet<>();
        for (NodeMotions.Motion motion : motions) {
            Optional<KeyframeSampler> moved = motion.translation();
            boolean isStraight = motion.rotation().isEmpty()
                    && motion.scale().isEmpty()
                    && (moved.isEmpty() || moved.get().isLinearByFrames(rate));
            if (!isStraight) {
                return IntStream.rangeClosed(0, film.frames()).toArray();
            }
            moved.ifPresent(keys -> {
                for (float t : keys.times()) {
                    ofKeys.add((int) StrictMath.rint(t * rate));
                }
            });
        }
        return ofKeys.stream().mapToInt(Integer::intValue).toArray();
    }
}

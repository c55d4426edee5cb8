package enlightenment.importer.gltf;

import enlightenment.importer.support.ImportNotes;
import java.io.IOException;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;

/** How nodes move: the channels of a file's first animation. */
final class NodeMotions {
    private static final int MOST_FRAMES = 100_000;

    /** The properties of a node that change; null for those that do not. */
    static final class Motion {
        private final NodeTree.Placing rest;
        private KeyframeSampler translation;
        private KeyframeSampler rotation;
        private KeyframeSampler scale;

        private Motion(NodeTree.Placing rest) {
            this.rest = rest;
        }

        /** Where the node is without the animation. */
        NodeTree.Placing rest() {
            return rest;
        }

        Optional<KeyframeSampler> translation() {
            return Optional.ofNullable(translation);
        }

        Optional<KeyframeSampler> rotation() {
            return Optional.ofNullable(rotation);
        }

        Optional<KeyframeSampler> scale() {
            return Optional.ofNullable(scale);
        }

        /** Leaves its scale as it is without the animation. */
        void keepRestScale() {
            scale = null;
        }

        /** Where the node is at a time in seconds. */
        NodeTree.Placing at(double time) {
            return new NodeTree.Placing(
                    translation == null ? rest.translation() : translation.at(time),
                    rotation == null ? rest.rotation() : rotation.at(time),
                    scale == null ? rest.scale() : scale.at(time));
        }
    }

    private final double framesPerSecond;
    private final Map<Integer, Motion> motions = new HashMap<>();
    private double seconds;

    private NodeMotions(double framesPerSecond) {
        this.framesPerSecond = framesPerSecond;
    }

    /** The motions of the first animation, with notes of all others and of channels that are left out. */
    static NodeMotions read(GltfElement document, GltfAccessors accessors, double framesPerSecond, ImportNotes notes)
            throws IOException {
        NodeMotions motions = new NodeMotions(framesPerSecond);
        int count = document.size("animations");
        if (count > 1) {
            notes.add("animations", "the first one counts: " + (count - 1) + " more left out");
        }
        if (count > 0) {
            GltfElement animation = document.item("animations", 0);
            for (GltfElement channel : animation.items("channels")) {
                motions.read(document, animation, channel, accessors, notes);
            }
            motions.requireFrames(animation);
        }
        return motions;
    }

    private void read(
            GltfElement document,
            GltfElement animation,
            GltfElement channel,
            GltfAccessors accessors,
            ImportNotes notes)
            throws IOException {
        GltfElement target = channel.get("target");
        String path = target.text("path", "");
        if (!path.matches("translation|rotation|scale") || !target.has("node")) {
            notes.add(
                    channel.place(),
                    path.equals("weights")
                            ? "a motion of morph targets is left out"
                            : "a motion of what is no node is left out");
            return;
        }
        int node = target.index("node", document.size("nodes")).orElseThrow();
        GltfElement element = document.item("nodes", node);
        if (element.has("matrix")) {
            throw channel.failure(
                    "moves a node with a matrix, which must have translation, rotation and scale instead");
        }
        int sampler = channel.index("sampler", animation.size("samplers"))
                .orElseThrow(() -> channel.failure("lacks \"sampler\""));
        KeyframeSampler keys =
                KeyframeSampler.read(animation.item("samplers", sampler), accessors, path.equals("rotation"));
        Motion motion = motions.get(node);
        if (motion == null) {
            motion = new Motion(NodeTree.placing(element));
            motions.put(node, motion);
        }
        switch (path) {
            case "translation" -> motion.translation = keys;
            case "rotation" -> motion.rotation = keys;
            default -> motion.scale = keys;
        }
        seconds = Math.max(seconds, keys.end());
    }

    private void requireFrames(GltfElement animation) throws IOException {
        if (seconds * framesPerSecond > MOST_FRAMES) {
            throw animation.failure("lasts " + seconds + " s, which is more than " + MOST_FRAMES + " frames of "
                    + framesPerSecond + " in a second");
        }
    }

    /** How a node moves within its parent; empty if it stands. */
    Optional<Motion> of(int node) {
        return Optional.ofNullable(motions.get(node));
    }

    /** The number of frames that end with the last key: frame n is at n / framesPerSecond seconds. At least 1. */
    int frames() {
        double exact = seconds * framesPerSecond;
        // A whole number of frames is one even where the last key's float is rounded upwards.
        return (int) Math.max(1, StrictMath.ceil(exact - exact * 0x1p-21));
    }

    double framesPerSecond() {
        return framesPerSecond;
    }

    /** The time of a frame in seconds. */
    double time(int frame) {
        return frame / framesPerSecond;
    }
}

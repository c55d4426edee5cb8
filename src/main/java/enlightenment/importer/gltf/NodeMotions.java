package enlightenment.importer.gltf;

import enlightenment.importer.support.ImportNotes;
import enlightenment.importer.support.NamedChoice;
import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;

/** How nodes move: the channels of an animation of a file. */
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

    private final OptionalInt animation;
    private final double framesPerSecond;
    private final Map<Integer, Motion> motions = new HashMap<>();
    private double seconds;

    private NodeMotions(OptionalInt animation, double framesPerSecond) {
        this.animation = animation;
        this.framesPerSecond = framesPerSecond;
    }

    /**
     * The motions of an animation, with notes of channels that are left out; of several animations a note says which one is taken, unless it was
     * chosen.
     *
     * @throws IOException listing the animations that there are, if there is none of that choice
     */
    static NodeMotions read(
            GltfElement document,
            GltfAccessors accessors,
            NamedChoice choice,
            double framesPerSecond,
            ImportNotes notes)
            throws IOException {
        List<String> names = new ArrayList<>();
        for (GltfElement animation : document.items("animations")) {
            names.add(animation.text("name", ""));
        }
        int index = choice.index(names);
        if (names.size() > 1 && choice.wanted().isEmpty()) {
            notes.add("animations", "of " + names.size() + ", the first is taken: " + NamedChoice.shown(names, index));
        }
        NodeMotions motions =
                new NodeMotions(names.isEmpty() ? OptionalInt.empty() : OptionalInt.of(index), framesPerSecond);
        if (!names.isEmpty()) {
            GltfElement animation = document.item("animations", index);
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

    /** The number of the animation; empty if the file has none. */
    OptionalInt animation() {
        return animation;
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

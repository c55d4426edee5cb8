package enlightenment.importer.gltf;

import enlightenment.geometry.Transform;
import enlightenment.geometry.Transform.Step;
import enlightenment.importer.support.Affine;
import enlightenment.importer.support.ImportNotes;
import enlightenment.math.Vec3;
import enlightenment.scene.Animation;
import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;

/**
 * Places objects by steps of their nodes, and makes tracks of the numbers that change. Nodes that stand, one above the other, are one matrix; a node
 * that moves is a scale, a rotation and a translation. A rotation about one axis is its angle; any other one is a matrix at each frame, between which a
 * linear matrix is off by at most θ²/8 of the distance from the pivot, θ the angle from frame to frame: the second derivative of the arc is θ².
 */
final class NodeTracks {
    /** Numbers of all keys: some hundred bytes each. */
    private static final long MOST_KEYS = 4_000_000;

    /** The places of a 3×3 matrix among the numbers of a matrix step. */
    private static final int[] LINEAR = {0, 1, 2, 4, 5, 6, 8, 9, 10};

    /** Numbers of a step that change: their pointers below the transform's first step, and where it goes. */
    private record Change(int step, String key, SampledProperty property, int number) {}

    /** The steps of a moving node at frame 0, and what changes in them. */
    private record NodeSteps(List<Step> steps, List<Change> changes) {}

    private final NodeTree nodes;
    private final NodeMotions motions;
    private final ImportNotes notes;
    private final Map<Integer, NodeSteps> moving = new HashMap<>();
    private final List<Animation.Track> tracks = new ArrayList<>();
    private long keys;

    NodeTracks(NodeTree nodes, NodeMotions motions, ImportNotes notes) {
        this.nodes = nodes;
        this.motions = motions;
        this.notes = notes;
    }

    /**
     * The transform, at frame 0, of what lies in a node.
     *
     * @param inner the map from its coordinates to those of the node
     * @throws enlightenment.math.InvalidValueException if it has no inverse
     */
    Transform transform(int node, Affine inner) throws IOException {
        List<Step> steps = new ArrayList<>();
        Affine standing = inner;
        for (int n = node; n >= 0; n = nodes.parent(n)) {
            // Else a chain of nodes would be walked once for each of as many objects.
            charge(n, 1);
            if (motions.of(n).isPresent()) {
                steps.addAll(standing.transform().steps());
                steps.addAll(steps(n).steps);
                standing = Affine.IDENTITY;
            } else {
                standing = nodes.local(n).after(standing);
            }
        }
        steps.addAll(standing.transform().steps());
        return Transform.of(steps);
    }

    /** Makes the tracks of an object that {@link #transform} has placed. */
    void move(int object, int node, Affine inner) throws IOException {
        int step = 0;
        Affine standing = inner;
        for (int n = node; n >= 0; n = nodes.parent(n)) {
            if (motions.of(n).isPresent()) {
                step += standing.transform().steps().size();
                for (Change change : steps(n).changes) {
                    String target = "/objects/" + object + "/transform/" + (step + change.step) + "/" + change.key;
                    var track = change.property.track(change.number);
                    charge(n, track.size());
                    tracks.add(new Animation.Track(target, track));
                }
                step += steps(n).steps.size();
                standing = Affine.IDENTITY;
            } else {
                standing = nodes.local(n).after(standing);
            }
        }
    }

    /**
     * Where a node is at the frames of the film.
     *
     * @throws IOException if that is beyond all numbers, or asks for too many keys
     */
    NodePoses poses(int node) throws IOException {
        if (!nodes.moves(node)) {
            return NodePoses.standing(nodes.toScene(node));
        }
        NodeChain chain = chain(node);
        int[] frames = chain.frames(motions);
        charge(node, (long) frames.length * (chain.motions().size() + 1));
        List<Affine> maps = new ArrayList<>();
        for (int frame : frames) {
            maps.add(chain.at(motions.time(frame)));
        }
        NodePoses poses = new NodePoses(chain.at(0), frames, maps);
        for (Affine map : poses.all()) {
            if (!(map.x().isFinite()
                    && map.y().isFinite()
                    && map.z().isFinite()
                    && map.offset().isFinite())) {
                throw nodes.node(node).failure("moves beyond all numbers");
            }
        }
        return poses;
    }

    private NodeChain chain(int node) throws IOException {
        NodeChain chain = new NodeChain(new ArrayList<>(), new ArrayList<>());
        Affine standing = Affine.IDENTITY;
        for (int n = node; n >= 0; n = nodes.parent(n)) {
            charge(n, 1);
            Optional<NodeMotions.Motion> motion = motions.of(n);
            if (motion.isPresent()) {
                // Decides whether its scale counts.
                steps(n);
                chain.motions().add(motion.get());
                chain.standing().add(standing);
                standing = Affine.IDENTITY;
            } else {
                standing = nodes.local(n).after(standing);
            }
        }
        chain.standing().add(standing);
        return chain;
    }

    /** Makes the tracks of a point or vector that a node carries. */
    void carry(String target, NodePoses poses, Function<Affine, Vec3> vector) throws IOException {
        SampledProperty numbers = poses.carried(map -> {
            Vec3 v = vector.apply(map);
            return new double[] {v.x(), v.y(), v.z()};
        });
        for (int axis = 0; axis < 3; axis++) {
            carry(target + "/" + axis, numbers, axis);
        }
    }

    /** Makes the track of a number that depends on the pose of a node. */
    void carryNumber(String target, NodePoses poses, ToDoubleFunction<Affine> number) throws IOException {
        carry(target, poses.carried(map -> new double[] {number.applyAsDouble(map)}), 0);
    }

    private void carry(String target, SampledProperty property, int number) throws IOException {
        var track = property.track(number);
        if (track.size() > 1) {
            charge(0, track.size());
            tracks.add(new Animation.Track(target, track));
        }
    }

    /** The animation of all that was moved; empty if nothing was. */
    Optional<Animation> animation() {
        return tracks.isEmpty()
                ? Optional.empty()
                : Optional.of(new Animation(motions.frames(), motions.framesPerSecond(), tracks));
    }

    private void charge(int node, long more) throws IOException {
        keys += more;
        if (keys > MOST_KEYS) {
            throw nodes.node(node)
                    .failure("moves by one key too many: motions have at most " + MOST_KEYS + " numbers, with those of"
                            + " each frame; fewer frames in a second need fewer");
        }
    }

    private NodeSteps steps(int node) throws IOException {
        NodeSteps known = moving.get(node);
        if (known == null) {
            known = new NodeSteps(new ArrayList<>(), new ArrayList<>());
            NodeMotions.Motion motion = motions.of(node).orElseThrow();
            addScale(node, motion, known);
            addRotation(node, motion, known);
            addTranslation(node, motion, known);
            moving.put(node, known);
        }
        return known;
    }

    private SampledProperty sampled(int node, KeyframeSampler sampler, boolean mayBeKeysAlone) throws IOException {
        charge(node, SampledProperty.most(sampler, motions));
        return SampledProperty.of(sampler, motions, mayBeKeysAlone);
    }

    private void addScale(int node, NodeMotions.Motion motion, NodeSteps to) throws IOException {
        double[] scale = motion.at(0).scale();
        if (motion.scale().isPresent()) {
            SampledProperty property = sampled(node, motion.scale().get(), true);
            if (vanishes(property)) {
                notes.add(
                        nodes.node(node).place(),
                        "its scale comes to 0, where nothing would be left: it keeps that of its rest");
                motion.keepRestScale();
                scale = motion.rest().scale();
            } else {
                addChanges(to, "scale/", property, 0, 1, 2);
            }
        }
        to.steps.add(new Transform.Scale(new Vec3(scale[0], scale[1], scale[2])));
    }

    /** Whether a factor is 0 somewhere. */
    private static boolean vanishes(SampledProperty scale) {
        double[] first = scale.values().get(0);
        return scale.values().stream()
                .anyMatch(v -> !(v[0] * first[0] > 0 && v[1] * first[1] > 0 && v[2] * first[2] > 0));
    }

    private void addRotation(int node, NodeMotions.Motion motion, NodeSteps to) throws IOException {
        if (motion.rotation().isEmpty()) {
            to.steps.addAll(
                    NodeTree.rotation(motion.rest().rotation()).transform().steps());
            return;
        }
        KeyframeSampler sampler = motion.rotation().get();
        Optional<Spin> spin = Spin.of(sampled(node, sampler, true));
        if (spin.isPresent()) {
            addChanges(to, "angle", spin.get().angles(), 0);
            double start = spin.get().angles().values().get(0)[0];
            to.steps.add(new Transform.RotateAbout(spin.get().axis(), start));
            return;
        }
        SampledProperty quaternions = sampled(node, sampler, false);
        charge(node, 2 * SampledProperty.most(sampler, motions));
        SampledProperty matrices = new SampledProperty(
                quaternions.frames(),
                quaternions.values().stream().map(NodeTracks::entries).toList());
        addChanges(to, "matrix/", matrices, LINEAR);
        Affine start = NodeTree.rotation(motion.at(0).rotation());
        to.steps.add(new Transform.Matrix(start.x(), start.y(), start.z(), Affine.exact(Vec3.ZERO)));
    }

    private static double[] entries(double[] quaternion) {
        Affine m = NodeTree.rotation(quaternion);
        return new double[] {
            m.x().x(), m.x().y(), m.x().z(), 0, m.y().x(), m.y().y(), m.y().z(), 0, m.z().x(), m.z().y(), m.z().z(), 0
        };
    }

    private void addTranslation(int node, NodeMotions.Motion motion, NodeSteps to) throws IOException {
        if (motion.translation().isPresent()) {
            addChanges(to, "translate/", sampled(node, motion.translation().get(), true), 0, 1, 2);
        }
        double[] t = motion.at(0).translation();
        to.steps.add(new Transform.Translate(Affine.exact(new Vec3(t[0], t[1], t[2]))));
    }

    /** Notes the numbers of the next step that change. A key that ends in a slash is that of an array. */
    private static void addChanges(NodeSteps to, String key, SampledProperty property, int... numbers) {
        for (int number : numbers) {
            if (property.track(number).size() > 1) {
                String pointer = key.endsWith("/") ? key + number : key;
                to.changes.add(new Change(to.steps.size(), pointer, property, number));
            }
        }
    }
}

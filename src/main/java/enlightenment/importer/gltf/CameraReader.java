package enlightenment.importer.gltf;

import enlightenment.camera.Camera;
import enlightenment.importer.support.Affine;
import enlightenment.importer.support.ImportDraft;
import enlightenment.importer.support.ImportView;
import enlightenment.importer.support.NamedChoice;
import enlightenment.math.InvalidValueException;
import enlightenment.math.Vec3;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;

/** The camera that the scene is seen through, looking along -z with y upwards; it says how wide the picture is, for its height. */
final class CameraReader {
    private static final int LONG_SIDE = 960;
    private static final double USUAL_ASPECT = 4.0 / 3;

    private final GltfElement document;
    private final ImportDraft draft;

    /** The number of the camera. */
    private final int wanted;

    private final boolean isChosen;

    CameraReader(GltfElement document, ImportDraft draft, NamedChoice choice) throws IOException {
        this.document = document;
        this.draft = draft;
        wanted = choice.index(names(document));
        isChosen = choice.wanted().isPresent();
    }

    /** What cameras are called: by their own names, else by those of the first nodes that they hang on. */
    private static List<String> names(GltfElement document) throws IOException {
        List<String> names = new ArrayList<>();
        for (GltfElement camera : document.items("cameras")) {
            names.add(camera.text("name", ""));
        }
        for (GltfElement node : document.items("nodes")) {
            int camera = node.index("camera", names.size()).orElse(-1);
            if (camera >= 0 && names.get(camera).isEmpty()) {
                names.set(camera, node.text("name", ""));
            }
        }
        return names;
    }

    /** Fails if a camera was chosen that no node of the scene has. */
    void requireChosen() throws IOException {
        if (isChosen && draft.camera().isEmpty()) {
            throw document.failure("cameras/" + wanted + ": hangs on no node of the scene that is shown");
        }
    }

    /** Whether a node has the camera that is wanted, and is the first one with it. */
    boolean isSeenFrom(GltfElement node) throws IOException {
        return node.index("camera", document.size("cameras")).orElse(-1) == wanted
                && draft.camera().isEmpty();
    }

    /** Takes the camera of a node at these poses, and makes its tracks. */
    void look(NodePoses poses, NodeTracks tracks) throws IOException {
        GltfElement camera = document.item("cameras", wanted);
        boolean isParallel = camera.has("orthographic");
        try {
            // The first is kept; the others fail here rather than in the midst of the film.
            for (Affine pose : poses.all()) {
                draft.camera(isParallel ? parallel(camera, pose) : pinhole(camera, pose));
            }
        } catch (InvalidValueException e) {
            throw camera.failure("gives no picture: " + e.getMessage());
        }
        tracks.carry("/camera/eye", poses, pose -> view(pose).eye());
        tracks.carry("/camera/lookAt", poses, pose -> view(pose).lookAt());
        tracks.carry("/camera/up", poses, pose -> view(pose).up());
        if (isParallel) {
            double height = Math.abs(camera.get("orthographic").number("ymag", 1));
            tracks.carryNumber("/camera/height", poses, pose -> height(pose, height));
        }
    }

    private static ImportView view(Affine pose) {
        return ImportView.of(pose, new Vec3(0, 0, -1), Vec3.Y, Vec3.X);
    }

    private Camera pinhole(GltfElement camera, Affine pose) throws IOException {
        GltfElement p = camera.get("perspective");
        double height = p.number("yfov", 0);
        if (!(height > 0 && height < StrictMath.PI)) {
            throw camera.failure("must have a yfov between 0 and pi");
        }
        size(camera, p.number("aspectRatio", USUAL_ASPECT));
        return view(pose).pinhole(StrictMath.toDegrees(height));
    }

    private Camera parallel(GltfElement camera, Affine pose) throws IOException {
        GltfElement o = camera.get("orthographic");
        double width = Math.abs(o.number("xmag", 1));
        double height = Math.abs(o.number("ymag", 1));
        if (width == 0 || height == 0) {
            throw camera.failure("must have an xmag and a ymag other than 0");
        }
        size(camera, width / height);
        return view(pose).parallel(height(pose, height));
    }

    /** The height of a parallel view in units of the scene, by half of it in those of its node. */
    private static double height(Affine pose, double half) {
        return 2 * half * pose.vector(Vec3.Y).length();
    }

    /** Sets the size of the picture. */
    private void size(GltfElement camera, double aspect) throws IOException {
        if (!(aspect >= 1.0 / LONG_SIDE && aspect <= LONG_SIDE)) {
            throw camera.failure("must have an aspect ratio between 1/" + LONG_SIDE + " and " + LONG_SIDE);
        }
        int width = aspect >= 1 ? LONG_SIDE : (int) Math.max(1, Math.round(LONG_SIDE * aspect));
        int height = aspect >= 1 ? (int) Math.max(1, Math.round(LONG_SIDE / aspect)) : LONG_SIDE;
        draft.size(width, height);
    }
}

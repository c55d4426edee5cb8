package enlightenment.scene.json;

import enlightenment.camera.Camera;
import enlightenment.light.Light;
import enlightenment.scene.Animation;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneObject;
import enlightenment.scene.Shading;
import enlightenment.scene.json.tree.JsonPointer;
import enlightenment.scene.json.tree.JsonTree;
import enlightenment.scene.json.tree.JsonValue;
import enlightenment.scene.json.tree.Problems;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;

/** Converts a JSON document into a scene, or reports all of its problems. */
final class SceneBinder {
    private static final int NO_INSTANT = -1;

    private final Values values;

    /**
     * @param folder the folder that paths of image files are relative to
     * @param contents contents of files in memory by their names; null if files are on the disk
     * @param files cache of mesh files, which further reads fill
     */
    SceneBinder(Problems problems, Path folder, Map<String, byte[]> contents, MeshCache files) {
        this.values = new Values(problems, new Library(folder, contents, files));
    }

    /** The scene of a text at a frame, without tracks applied if that is empty; null after a problem. */
    Scene read(JsonTree.Source source, OptionalInt frame) {
        return read(source, frame, NO_INSTANT);
    }

    /**
     * The scene of a text at one of the shutter instants of a frame; null after a problem.
     *
     * @param instant counted from 0; or -1 for the time of the frame
     */
    Scene read(JsonTree.Source source, OptionalInt frame, int instant) {
        ObjectStream objects = new ObjectStream(source, values);
        JsonValue root = objects.readAll();
        Fields f = root == null ? null : Fields.of(root, JsonPointer.ROOT, PartKeys.SCENE, values);
        if (f == null) {
            return null;
        }
        JsonValue.Obj scene = (JsonValue.Obj) root;
        Animation animation = null;
        if (f.has("animation")) {
            objects.keepTargets(scene);
            animation = new Tracks(root, values).read(f.get("animation"), f.at("animation"));
        }
        if (frame.isPresent()) {
            setFrame(f, animation, frame.getAsInt(), instant, root);
        }
        objects.prepare(scene, animation != null && frame.isPresent());
        return scene(f, animation, objects);
    }

    private static void setFrame(Fields f, Animation animation, int frame, int instant, JsonValue root) {
        if (!f.has("animation")) {
            f.problem("animation", "missing: the scene has no animation, so it has no frame " + frame);
        } else if (animation != null && (frame < 0 || frame >= animation.frames())) {
            f.problem("animation", "there is no frame " + frame + "; the frames are 0.." + (animation.frames() - 1));
        } else if (animation != null) {
            Moment time = instant < 0 ? Moment.of(frame) : Moment.instant(animation, frame, instant);
            Tracks.apply(animation, time, root);
        }
    }

    private Scene scene(Fields f, Animation animation, ObjectStream stream) {
        f.text("$schema", "the address of the schema");
        String name = f.text("name", "a text");
        Fields image = f.has("image") ? Fields.of(f.get("image"), f.at("image"), PartKeys.IMAGE, values) : null;
        int width = image == null ? 1 : image.integer("width", 1, Scene.MAX_SIDE, 1);
        int height = image == null ? 1 : image.integer("height", 1, Scene.MAX_SIDE, 1);
        Camera camera = f.has("camera") ? Cameras.read(f.get("camera"), f.at("camera"), values) : null;
        Shading shading =
                f.has("shading") ? Shadings.read(f.get("shading"), f.at("shading"), values) : Shading.Classic.DEFAULT;
        Scene.Display display =
                f.has("display") ? Displays.read(f.get("display"), f.at("display"), values) : Scene.Display.DEFAULT;
        stream.tellLibrary();
        List<Light> lights = f.has("lights") ? Lights.read(f.get("lights"), f.at("lights"), values) : List.of();
        List<SceneObject> objects = f.has("objects") ? stream.objects(f.get("objects"), f.at("objects")) : List.of();
        RenderSettings.Defaults render = f.has("render")
                ? RenderPart.read(f.get("render"), f.at("render"), values)
                : RenderSettings.Defaults.DEFAULT;
        return f.make(() -> new Scene(
                name == null ? "" : name,
                width,
                height,
                camera,
                shading,
                display,
                values.library().textures,
                values.library().materials,
                lights,
                objects,
                render,
                Optional.ofNullable(animation),
                List.of()));
    }
}

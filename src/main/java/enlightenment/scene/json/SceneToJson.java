package enlightenment.scene.json;

import enlightenment.material.Material;
import enlightenment.scene.Animation;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneObject;
import enlightenment.scene.json.tree.JsonPointer;
import enlightenment.scene.json.tree.JsonValue;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;

/** Converts a scene into JSON. */
final class SceneToJson {
    private final Scene scene;
    private final Names names;

    /** @param fileNames names of files in the text */
    SceneToJson(Scene scene, FileNaming fileNames) {
        this.scene = scene;
        this.names = new Names(scene, fileNames);
    }

    JsonValue json() {
        JsonObjectBuilder root = new JsonObjectBuilder(JsonPointer.ROOT, names);
        if (!scene.name().isEmpty()) {
            root.text("name", scene.name());
        }
        root.put(
                "image",
                root.child("image")
                        .whole("width", scene.width())
                        .whole("height", scene.height())
                        .json());
        root.put("camera", json(Cameras.FAMILY, scene.camera(), root.child("camera")));
        root.put("shading", Shadings.write(scene.shading(), root.child("shading")));
        JsonObjectBuilder display = Displays.write(scene.display(), root.child("display"));
        if (!display.isEmpty()) {
            root.put("display", display.json());
        }
        putNamed(root, "textures", Textures.FAMILY, names.textures(), name -> {});
        putNamed(root, "materials", Materials.FAMILY, scene.materials(), names::wroteMaterial);
        if (!scene.lights().isEmpty()) {
            List<JsonValue> lights = new ArrayList<>();
            scene.lights().forEach(l -> lights.add(json(Lights.FAMILY, l, root.child("lights", lights.size()))));
            root.put("lights", JsonValue.Arr.of(lights));
        }
        List<JsonValue> objects = new ArrayList<>(scene.objects().size());
        scene.objects().forEach(o -> objects.add(object(o, root.child("objects", objects.size()))));
        root.put("objects", JsonValue.Arr.of(objects));
        root.put("render", RenderPart.write(scene.render(), scene.animation().orElse(null), root.child("render")));
        scene.animation().ifPresent(a -> root.put("animation", animation(a, root.child("animation"))));
        return root.json();
    }

    private static <T> JsonValue json(Family<T> family, T value, JsonObjectBuilder p) {
        family.write(value, p);
        return p.json();
    }

    private static <T> void putNamed(
            JsonObjectBuilder root, String key, Family<T> family, Map<String, T> values, Consumer<String> wrote) {
        JsonObjectBuilder all = root.child(key);
        values.forEach((name, value) -> {
            all.put(name, json(family, value, all.child(name)));
            wrote.accept(name);
        });
        if (!all.isEmpty()) {
            root.put(key, all.json());
        }
    }

    /** Names files by their paths relative to a folder. */
    static FileNaming relativeTo(Path baseFolder) {
        Path folder = baseFolder.toAbsolutePath().normalize();
        return file -> {
            Path absolute = file.toAbsolutePath().normalize();
            boolean sameRoot = folder.getRoot() != null && folder.getRoot().equals(absolute.getRoot());
            String path = (sameRoot ? folder.relativize(absolute) : absolute).toString();
            return path.replace(folder.getFileSystem().getSeparator(), "/");
        };
    }

    private JsonValue object(SceneObject object, JsonObjectBuilder p) {
        if (!object.name().isEmpty()) {
            p.text("name", object.name());
        }
        Shapes.FAMILY.write(object.shape(), p);
        if (!object.faces().isEmpty()) {
            List<JsonValue> faces = new ArrayList<>();
            for (Material face : object.faces()) {
                faces.add(use(
                        face, p.child("faces", faces.size()), p.child("faces").animated("" + faces.size())));
            }
            p.put("faces", JsonValue.Arr.of(faces));
        }
        boolean implied = !object.faces().isEmpty() && object.faces().get(0).equals(object.material());
        if (!implied || p.animated("material")) {
            p.put("material", use(object.material(), p.child("material"), p.animated("material")));
        }
        return p.json();
    }

    private JsonValue use(Material material, JsonObjectBuilder p, boolean animated) {
        String name = names.of(material);
        return name == null || animated ? json(Materials.FAMILY, material, p) : new JsonValue.Str(0, 0, name);
    }

    private static JsonValue animation(Animation animation, JsonObjectBuilder p) {
        p.whole("frames", animation.frames()).number("framesPerSecond", animation.framesPerSecond());
        List<JsonValue> tracks = new ArrayList<>();
        for (Animation.Track track : animation.tracks()) {
            JsonObjectBuilder t = p.child("tracks", tracks.size());
            JsonObjectBuilder keys = t.child("keys");
            // Not shortened: keys are equal only with all their digits.
            track.keys().forEach((frame, v) -> keys.put(frame.toString(), new JsonValue.Num(0, 0, v.toString())));
            t.text("target", track.target()).put("keys", keys.json());
            if (track.easing() != Animation.Easing.LINEAR) {
                t.text("easing", Fields.word(track.easing()));
            }
            tracks.add(t.json());
        }
        p.put("tracks", JsonValue.Arr.of(tracks));
        if (animation.shutter() != 0) {
            p.number("shutter", animation.shutter());
        }
        if (animation.instants() != Animation.USUAL_INSTANTS) {
            p.whole("instants", animation.instants());
        }
        return p.json();
    }
}

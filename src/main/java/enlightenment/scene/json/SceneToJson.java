package enlightenment.scene.json;

import enlightenment.camera.Camera;
import enlightenment.light.Light;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.scene.Animation;
import enlightenment.scene.ClassicShading;
import enlightenment.scene.RenderDefaults;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneObject;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeSet;
import java.util.function.Function;

/** Turns a scene into JSON. */
final class SceneToJson {
    private final Scene scene;
    private final Function<Path, String> fileNames;
    private final TreeSet<String> targets = new TreeSet<>();
    private final Map<String, Texture> textures;
    private final Map<Texture, String> textureNames = new HashMap<>();
    private final Map<Material, String> materialNames = new HashMap<>();

    /** @param fileNames how image files are called in the text */
    SceneToJson(Scene scene, Function<Path, String> fileNames) {
        this.scene = scene;
        this.fileNames = fileNames;
        this.textures = new LinkedHashMap<>(scene.textures());
        scene.animation().ifPresent(a -> a.tracks().forEach(t -> targets.add(t.target())));
        textures.forEach((name, texture) -> textureNames.putIfAbsent(texture, name));
        scene.materials().forEach((name, material) -> materialNames.putIfAbsent(material, name));
        nameTextures();
    }

    private void nameTextures() {
        scene.materials().values().forEach(this::nameTexture);
        for (SceneObject object : scene.objects()) {
            nameTexture(object.material());
            object.faces().forEach(this::nameTexture);
        }
    }

    private void nameTexture(Material material) {
        Texture texture = material.color();
        if (texture instanceof Texture.Solid || textureNames.containsKey(texture)) {
            return;
        }
        int n = 1;
        while (textures.containsKey("texture " + n)) {
            n++;
        }
        textures.put("texture " + n, texture);
        textureNames.put(texture, "texture " + n);
    }

    JsonValue json() {
        JsonObjectBuilder root = new JsonObjectBuilder(JsonPointer.ROOT, targets);
        if (!scene.name().isEmpty()) {
            root.text("name", scene.name());
        }
        root.put(
                "image",
                root.child("image")
                        .whole("width", scene.width())
                        .whole("height", scene.height())
                        .json());
        root.put("camera", camera(scene.camera(), root.child("camera")));
        root.put("shading", shading(scene.shading(), root.child("shading")));
        putUnlessEmpty(root, "textures", textures());
        putUnlessEmpty(root, "materials", materials());
        if (!scene.lights().isEmpty()) {
            List<JsonValue> lights = new ArrayList<>();
            scene.lights().forEach(l -> lights.add(light(l, root.child("lights", lights.size()))));
            root.put("lights", JsonValue.Arr.of(lights));
        }
        List<JsonValue> objects = new ArrayList<>(scene.objects().size());
        scene.objects().forEach(o -> objects.add(object(o, root.child("objects", objects.size()))));
        root.put("objects", JsonValue.Arr.of(objects));
        root.put("render", render(scene.render(), root.child("render")));
        scene.animation().ifPresent(a -> root.put("animation", animation(a, root.child("animation"))));
        return root.json();
    }

    private static void putUnlessEmpty(JsonObjectBuilder root, String key, JsonObjectBuilder part) {
        if (!part.isEmpty()) {
            root.put(key, part.json());
        }
    }

    private static JsonValue camera(Camera camera, JsonObjectBuilder p) {
        p.text("type", camera.type());
        if (camera instanceof Camera.Window w) {
            p.point("eye", w.eye()).point("lowerLeft", w.lowerLeft()).point("upperLeft", w.upperLeft());
            p.point("upperRight", w.upperRight()).point("lowerRight", w.lowerRight());
            p.numberUnless(0, "pupilRadius", w.pupilRadius());
        } else if (camera instanceof Camera.Perspective c) {
            p.point("eye", c.eye()).point("lookAt", c.lookAt()).vector("up", c.up());
            p.number("fieldOfView", c.fieldOfView());
        } else if (camera instanceof Camera.Orthographic c) {
            p.point("eye", c.eye()).point("lookAt", c.lookAt()).vector("up", c.up());
            p.number("height", c.height());
        } else if (camera instanceof Camera.Isometric c) {
            p.point("lookAt", c.lookAt()).number("height", c.height());
        }
        return p.json();
    }

    private static JsonValue shading(ClassicShading s, JsonObjectBuilder p) {
        p.text("model", "classic").number("ambient", s.ambient()).number("shadow", s.shadow());
        p.colorUnless(ClassicShading.DEFAULT.background(), "background", s.background());
        return p.wholeUnless(ClassicShading.DEFAULT.maxBounces(), "maxBounces", s.maxBounces())
                .json();
    }

    private static JsonValue render(RenderDefaults r, JsonObjectBuilder p) {
        p.text("method", r.method().word()).whole("antialias", r.antialias()).whole("shadowSamples", r.shadowSamples());
        return p.wholeUnless(0, "seed", r.seed()).json();
    }

    private static JsonValue light(Light light, JsonObjectBuilder p) {
        p.text("type", light.type());
        if (light instanceof Light.Sphere s) {
            p.point("center", s.center()).number("radius", s.radius());
        } else if (light instanceof Light.Rectangle r) {
            p.points("corners", r.lowerLeft(), r.upperLeft(), r.upperRight(), r.lowerRight());
        } else if (light instanceof Light.Point q) {
            p.point("position", q.position());
        }
        return p.color("color", light.color()).json();
    }

    private JsonObjectBuilder textures() {
        JsonObjectBuilder all = new JsonObjectBuilder(JsonPointer.ROOT.child("textures"), targets);
        textures.forEach((name, texture) -> all.put(name, texture(texture, all.child(name))));
        return all;
    }

    private JsonValue texture(Texture texture, JsonObjectBuilder p) {
        if (texture instanceof Texture.File f) {
            p.text("file", fileNames.apply(f.file()));
            if (f.filter() != Texture.Filter.BILINEAR) {
                p.text("filter", f.filter().name().toLowerCase(Locale.ROOT));
            }
            if (f.encoding() != Texture.Encoding.SRGB) {
                p.text("encoding", f.encoding().name().toLowerCase(Locale.ROOT));
            }
        } else if (texture instanceof Texture.Checker c) {
            p.text("type", "checker").colors("colors", c.colors()).number("scale", c.scale());
        } else if (texture instanceof Texture.Solid s) {
            p.text("type", "color").color("color", s.color());
        }
        return p.json();
    }

    /** Calls image files by their paths relative to a folder. */
    static Function<Path, String> relativeTo(Path baseFolder) {
        Path folder = baseFolder.toAbsolutePath().normalize();
        return file -> {
            Path absolute = file.toAbsolutePath().normalize();
            boolean sameRoot = folder.getRoot() != null && folder.getRoot().equals(absolute.getRoot());
            String path = (sameRoot ? folder.relativize(absolute) : absolute).toString();
            return path.replace(folder.getFileSystem().getSeparator(), "/");
        };
    }

    private JsonObjectBuilder materials() {
        JsonObjectBuilder all = new JsonObjectBuilder(JsonPointer.ROOT.child("materials"), targets);
        scene.materials().forEach((name, material) -> all.put(name, material(material, all.child(name))));
        return all;
    }

    private JsonValue material(Material material, JsonObjectBuilder p) {
        p.text("type", material.type());
        Texture color = material.color();
        if (color instanceof Texture.Solid s && (p.animated("color") || !textureNames.containsKey(color))) {
            p.color("color", s.color());
        } else {
            p.put(
                    "color",
                    p.child("color").text("texture", textureNames.get(color)).json());
        }
        if (material instanceof Material.Glass g) {
            p.number("indexOfRefraction", g.indexOfRefraction());
            p.numberUnless(1, "transparency", g.transparency()).wholeUnless(0, "priority", g.priority());
        }
        return p.flagUnless(true, "receivesShadows", material.receivesShadows()).json();
    }

    private JsonValue object(SceneObject object, JsonObjectBuilder p) {
        if (!object.name().isEmpty()) {
            p.text("name", object.name());
        }
        ShapeToJson.put(object.shape(), p);
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
        String name = materialNames.get(material);
        return name == null || animated ? material(material, p) : new JsonValue.Str(0, 0, name);
    }

    private static JsonValue animation(Animation animation, JsonObjectBuilder p) {
        p.whole("frames", animation.frames()).number("framesPerSecond", animation.framesPerSecond());
        List<JsonValue> tracks = new ArrayList<>();
        for (Animation.Track track : animation.tracks()) {
            JsonObjectBuilder t = p.child("tracks", tracks.size());
            JsonObjectBuilder keys = t.child("keys");
            // Not shortened: keys are equal only with all their digits.
            track.keys().forEach((frame, v) -> keys.put(frame.toString(), new JsonValue.Num(0, 0, v.toString())));
            tracks.add(t.text("target", track.target()).put("keys", keys.json()).json());
        }
        return p.put("tracks", JsonValue.Arr.of(tracks)).json();
    }
}

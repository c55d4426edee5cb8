package enlightenment.scene.json;

import enlightenment.camera.Camera;
import enlightenment.light.Light;
import enlightenment.material.Material;
import enlightenment.scene.Animation;
import enlightenment.scene.ClassicShading;
import enlightenment.scene.RenderDefaults;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneObject;
import java.io.IOException;
import java.math.BigDecimal;
import java.nio.file.AtomicMoveNotSupportedException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Writes scene files that {@link SceneReader} reads back as an equal scene.
 *
 * <p>One thing is added where it must be: an image or checker texture of a material that {@link Scene#textures()} does
 * not hold gets a name, because the format has such textures by name only.
 */
public final class SceneWriter {
    private SceneWriter() {}

    /**
     * Writes a scene file. A file that is there already is replaced at once: whoever reads it meanwhile sees the old one
     * or the new one.
     *
     * @throws IOException where the file cannot be written; what was there is still there then
     * @throws IllegalArgumentException for a coordinate that the format cannot hold; see {@link #toJson}
     */
    public static void write(Scene scene, Path file) throws IOException {
        Path absolute = file.toAbsolutePath();
        String json = toJson(scene, absolute.getParent());
        Path target = Files.exists(absolute) ? absolute.toRealPath() : absolute;
        String name = "." + target.getFileName() + "." + Long.toHexString(System.nanoTime()) + ".tmp";
        Path temporary = target.resolveSibling(name);
        try {
            Files.writeString(temporary, json, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE);
            try {
                Files.move(temporary, target, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
            } catch (AtomicMoveNotSupportedException e) {
                Files.move(temporary, target, StandardCopyOption.REPLACE_EXISTING);
            }
        } finally {
            Files.deleteIfExists(temporary);
        }
    }

    /**
     * The text of a scene file.
     *
     * @param baseFolder the folder that the file will lie in; paths of textures are written relative to it
     * @throws IllegalArgumentException for a coordinate of more than 1200 digits, or one that no double comes near
     */
    static String toJson(Scene scene, Path baseFolder) {
        // The tracks of an animation point at numbers of the file, so each number must be where they expect it.
        boolean full = scene.animation().isPresent();
        boolean colorsAsNumbers = full && pointsAtColor(scene.animation().get());
        MaterialText materials = new MaterialText(scene, baseFolder, full, colorsAsNumbers);
        Map<String, Object> named = new LinkedHashMap<>();
        for (Map.Entry<String, Material> e : scene.materials().entrySet()) {
            named.put(e.getKey(), materials.definition(e.getValue()));
        }
        List<Object> objects = new ArrayList<>(scene.objects().size());
        for (SceneObject object : scene.objects()) {
            objects.add(object(object, materials, full));
        }
        List<Object> lights = new ArrayList<>();
        for (Light light : scene.lights()) {
            lights.add(light(light, colorsAsNumbers));
        }
        Map<String, Object> textures = materials.textures();

        Map<String, Object> to = new LinkedHashMap<>();
        if (!scene.name().isEmpty()) {
            to.put("name", JsonText.quote(scene.name()));
        }
        to.put("image", map("width", Integer.toString(scene.width()), "height", Integer.toString(scene.height())));
        to.put("camera", camera(scene.camera(), full));
        to.put("shading", shading(scene.shading(), colorsAsNumbers));
        if (!textures.isEmpty()) {
            to.put("textures", textures);
        }
        if (!named.isEmpty()) {
            to.put("materials", named);
        }
        to.put("lights", lights);
        to.put("objects", objects);
        to.put("render", render(scene.render()));
        if (full) {
            to.put("animation", animation(scene.animation().get()));
        }
        return JsonText.print(to);
    }

    private static boolean pointsAtColor(Animation animation) {
        for (Animation.Track track : animation.tracks()) {
            String target = track.target();
            if (target.contains("/color") || target.contains("/background")) {
                return true;
            }
        }
        return false;
    }

    /** A map in the order of the arguments: key, value, key, value, … */
    private static Map<String, Object> map(Object... keysAndValues) {
        Map<String, Object> map = new LinkedHashMap<>();
        for (int i = 0; i < keysAndValues.length; i += 2) {
            map.put((String) keysAndValues[i], keysAndValues[i + 1]);
        }
        return map;
    }

    private static Object camera(Camera camera, boolean full) {
        Map<String, Object> to = map("type", JsonText.quote(camera.type()));
        if (camera instanceof Camera.Window w) {
            to.put("eye", Tokens.point(w.eye()));
            to.put("lowerLeft", Tokens.point(w.lowerLeft()));
            to.put("upperLeft", Tokens.point(w.upperLeft()));
            to.put("upperRight", Tokens.point(w.upperRight()));
            to.put("lowerRight", Tokens.point(w.lowerRight()));
            if (full || Double.compare(w.pupilRadius(), 0.0) != 0) {
                to.put("pupilRadius", Tokens.number(w.pupilRadius()));
            }
        } else if (camera instanceof Camera.Perspective p) {
            to.put("eye", Tokens.point(p.eye()));
            to.put("lookAt", Tokens.point(p.lookAt()));
            to.put("up", Tokens.vector(p.up()));
            to.put("fieldOfView", Tokens.number(p.fieldOfView()));
        } else if (camera instanceof Camera.Orthographic o) {
            to.put("eye", Tokens.point(o.eye()));
            to.put("lookAt", Tokens.point(o.lookAt()));
            to.put("up", Tokens.vector(o.up()));
            to.put("height", Tokens.number(o.height()));
        } else {
            Camera.Isometric i = (Camera.Isometric) camera;
            to.put("lookAt", Tokens.point(i.lookAt()));
            to.put("height", Tokens.number(i.height()));
        }
        return to;
    }

    private static Object shading(ClassicShading s, boolean colorsAsNumbers) {
        return map(
                "model", "\"classic\"",
                "ambient", Tokens.number(s.ambient()),
                "shadow", Tokens.number(s.shadow()),
                "background", Tokens.color(s.background(), colorsAsNumbers),
                "maxBounces", Integer.toString(s.maxBounces()));
    }

    private static Object light(Light light, boolean colorsAsNumbers) {
        Map<String, Object> to = map("type", JsonText.quote(light.type()));
        if (light instanceof Light.Sphere s) {
            to.put("center", Tokens.point(s.center()));
            to.put("radius", Tokens.number(s.radius()));
        } else if (light instanceof Light.Rectangle r) {
            to.put("corners", Tokens.points(r.lowerLeft(), r.upperLeft(), r.upperRight(), r.lowerRight()));
        } else {
            to.put("position", Tokens.point(((Light.Point) light).position()));
        }
        to.put("color", Tokens.color(light.color(), colorsAsNumbers));
        return to;
    }

    private static Object object(SceneObject object, MaterialText materials, boolean full) {
        Map<String, Object> to = new LinkedHashMap<>();
        if (!object.name().isEmpty()) {
            to.put("name", JsonText.quote(object.name()));
        }
        to.put("type", JsonText.quote(object.shape().type()));
        ShapeText.write(object.shape(), full, to);
        to.put("material", materials.material(object.material()));
        if (!object.faces().isEmpty()) {
            List<Object> faces = new ArrayList<>();
            for (Material face : object.faces()) {
                faces.add(materials.material(face));
            }
            to.put("faces", faces);
        }
        return to;
    }

    private static Object render(RenderDefaults r) {
        return map(
                "method", JsonText.quote(r.method()),
                "antialias", Integer.toString(r.antialias()),
                "shadowSamples", Integer.toString(r.shadowSamples()),
                "seed", Long.toString(r.seed()));
    }

    private static Object animation(Animation animation) {
        List<Object> tracks = new ArrayList<>();
        for (Animation.Track track : animation.tracks()) {
            Map<String, Object> keys = new LinkedHashMap<>();
            for (Map.Entry<Integer, BigDecimal> e : track.keys().entrySet()) {
                keys.put(e.getKey().toString(), Tokens.exact(e.getValue()));
            }
            tracks.add(map("target", JsonText.quote(track.target()), "keys", keys));
        }
        return map(
                "frames", Integer.toString(animation.frames()),
                "framesPerSecond", Tokens.number(animation.framesPerSecond()),
                "tracks", tracks);
    }
}

package enlightenment.scene.json;

import enlightenment.camera.Camera;
import enlightenment.color.DisplayRgb;
import enlightenment.geometry.Shape;
import enlightenment.light.Light;
import enlightenment.material.Material;
import enlightenment.math.Check.InvalidValueException;
import enlightenment.scene.Animation;
import enlightenment.scene.ClassicShading;
import enlightenment.scene.RenderDefaults;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneObject;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Turns a document into a {@link Scene}, and records whatever speaks against that. */
final class SceneBinder {
    private final Values values;
    private final Problems problems;
    private final MaterialBinder materials;
    private final Map<String, Node> names = new HashMap<>();

    private SceneBinder(Problems problems, Path folder) {
        this.problems = problems;
        this.values = new Values(problems);
        this.materials = new MaterialBinder(values, folder);
    }

    /** The scene, or null after a problem. */
    static Scene bind(Node root, Problems problems, Path folder, Integer frame) {
        SceneBinder binder = new SceneBinder(problems, folder);
        Node.Obj o = binder.values.object(root, "a scene (an object)");
        return o == null ? null : binder.scene(o, frame);
    }

    private Scene scene(Node.Obj root, Integer frame) {
        Fields f = new Fields(root, values);
        f.only(
                "a scene",
                "name",
                "image",
                "camera",
                "shading",
                "textures",
                "materials",
                "lights",
                "objects",
                "render",
                "animation");
        // First of all, because it changes the numbers that the rest is made of.
        Animation animation = animation(f, frame);
        String name = f.string("name", "");
        Node imageNode = f.required("image", "an object with \"width\" and \"height\"");
        int[] image = imageNode == null ? null : image(imageNode);
        Node cameraNode = f.required("camera", "a camera (an object)");
        Node.Obj cameraObject = cameraNode == null ? null : values.object(cameraNode, "a camera (an object)");
        Camera camera = cameraObject == null ? null : CameraBinder.read(new Fields(cameraObject, values), problems);
        ClassicShading shading = f.has("shading") ? shading(f.optional("shading")) : ClassicShading.DEFAULT;
        if (f.has("textures")) {
            materials.readTextures(f.optional("textures"));
        }
        if (f.has("materials")) {
            materials.readMaterials(f.optional("materials"));
        }
        List<Light> lights = lights(f.list("lights", "an array of lights"));
        f.required("objects", "an array of objects");
        List<SceneObject> objects = objects(f.list("objects", "an array of objects"));
        RenderDefaults render = f.has("render") ? render(f.optional("render")) : RenderDefaults.DEFAULT;
        if (!f.sound()) {
            return null;
        }
        try {
            return new Scene(
                    name,
                    image[0],
                    image[1],
                    camera,
                    shading,
                    materials.textures,
                    materials.materials,
                    lights,
                    objects,
                    render,
                    Optional.ofNullable(animation));
        } catch (InvalidValueException e) {
            f.refuse(e);
            return null;
        }
    }

    private Animation animation(Fields f, Integer frame) {
        Node node = f.optional("animation");
        if (node != null) {
            return new AnimationBinder(f.object, values, frame).read(node);
        }
        if (frame != null) {
            problems.at(f.object, "animation", "is missing: the scene has no frames, so no frame " + frame);
        }
        return null;
    }

    private int[] image(Node node) {
        Node.Obj o = values.object(node, "an object with \"width\" and \"height\"");
        if (o == null) {
            return null;
        }
        Fields f = new Fields(o, values).only("an image", "width", "height");
        return new int[] {f.whole("width", 1, Scene.MAX_SIDE), f.whole("height", 1, Scene.MAX_SIDE)};
    }

    private ClassicShading shading(Node node) {
        Node.Obj o = values.object(node, "a shading (an object)");
        if (o == null) {
            return null;
        }
        Fields f = new Fields(o, values);
        Node model = f.optional("model");
        if (model instanceof Node.Str && ((Node.Str) model).text.equals("physical")) {
            problems.at(model, "shading \"physical\" is not available yet; expected \"classic\"");
            return null;
        }
        f.word("model", "a model of shading", "classic");
        f.only("classic shading", "model", "ambient", "shadow", "background", "maxBounces");
        ClassicShading fallback = ClassicShading.DEFAULT;
        double ambient = f.number("ambient", fallback.ambient());
        double shadow = f.number("shadow", fallback.shadow());
        DisplayRgb background = f.color("background", fallback.background());
        int maxBounces = (int) f.whole("maxBounces", 0, 1_000_000, fallback.maxBounces());
        try {
            return f.sound() ? new ClassicShading(ambient, shadow, background, maxBounces) : null;
        } catch (InvalidValueException e) {
            f.refuse(e);
            return null;
        }
    }

    private RenderDefaults render(Node node) {
        Node.Obj o = values.object(node, "settings for rendering (an object)");
        if (o == null) {
            return null;
        }
        Fields f = new Fields(o, values).only("render", "method", "antialias", "shadowSamples", "seed");
        String method = f.word("method", "a method", "raytrace", "cluster");
        RenderDefaults fallback = RenderDefaults.DEFAULT;
        int antialias = (int) f.whole("antialias", 1, RenderDefaults.MAX_ANTIALIAS, fallback.antialias());
        int shadowSamples =
                (int) f.whole("shadowSamples", 1, RenderDefaults.MAX_SHADOW_SAMPLES, fallback.shadowSamples());
        long seed = f.whole("seed", Long.MIN_VALUE, Long.MAX_VALUE, fallback.seed());
        return f.sound() ? new RenderDefaults(method, antialias, shadowSamples, seed) : null;
    }

    private List<Light> lights(List<Node> nodes) {
        List<Light> lights = new ArrayList<>(nodes.size());
        for (Node node : nodes) {
            Node.Obj o = values.object(node, "a light (an object)");
            Light light = o == null ? null : LightBinder.read(new Fields(o, values), problems);
            if (light != null) {
                lights.add(light);
            }
        }
        return lights;
    }

    private List<SceneObject> objects(List<Node> nodes) {
        List<SceneObject> objects = new ArrayList<>(nodes.size());
        for (Node node : nodes) {
            Node.Obj o = values.object(node, "a thing (an object)");
            SceneObject object = o == null ? null : object(new Fields(o, values));
            if (object != null) {
                objects.add(object);
            }
        }
        return objects;
    }

    private SceneObject object(Fields f) {
        Node nameNode = f.optional("name");
        String name = nameNode == null ? "" : values.string(nameNode);
        if (name != null && !name.isEmpty()) {
            Node earlier = names.putIfAbsent(name, nameNode);
            if (earlier != null) {
                problems.at(
                        nameNode,
                        "must be a name of its own, but " + Node.quote(name) + " is already the name of "
                                + earlier.parent.pointer() + " in line " + earlier.line);
            }
        }
        Node materialNode = f.required("material", "the name of a material, or a material (an object)");
        Material material = materialNode == null ? null : materials.material(materialNode);
        Shape shape = ShapeBinder.read(f, problems);
        List<Material> faces = List.of();
        if (shape != null && shape.type().equals("cube") && f.has("faces")) {
            faces = faces(f.optional("faces"));
        }
        if (name == null || material == null || shape == null || faces == null) {
            return null;
        }
        return new SceneObject(name, shape, material, faces);
    }

    private List<Material> faces(Node node) {
        List<Node> six = values.array(node, 6, "an array of the materials of six faces: -x, +x, -y, +y, -z, +z");
        if (six == null) {
            return null;
        }
        List<Material> faces = new ArrayList<>(6);
        for (Node face : six) {
            Material material = materials.material(face);
            if (material == null) {
                return null;
            }
            faces.add(material);
        }
        return faces;
    }
}

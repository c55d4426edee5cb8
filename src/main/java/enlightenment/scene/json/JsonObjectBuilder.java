package enlightenment.scene.json;

import enlightenment.color.Color;
import enlightenment.color.DisplayRgb;
import enlightenment.color.Rgb;
import enlightenment.geometry.Mesh;
import enlightenment.geometry.Transform;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.mesh.MeshFiles;
import enlightenment.scene.SceneException;
import enlightenment.scene.json.tree.JsonPointer;
import enlightenment.scene.json.tree.JsonTree;
import enlightenment.scene.json.tree.JsonValue;
import enlightenment.scene.json.tree.Numbers;
import enlightenment.text.Plain;
import java.math.BigDecimal;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Builder of the JSON object of one part of a scene, the inverse of {@link Fields}. */
final class JsonObjectBuilder {
    private final JsonPointer place;
    private final Names names;
    private final Map<String, JsonValue> values = new LinkedHashMap<>();

    /**
     * @param names names of textures, materials and files, and targets of tracks; null for a part without any
     */
    JsonObjectBuilder(JsonPointer place, Names names) {
        this.place = place;
        this.names = names;
    }

    JsonObjectBuilder child(String key) {
        return new JsonObjectBuilder(place.child(key), names);
    }

    JsonObjectBuilder child(String key, int index) {
        return new JsonObjectBuilder(place.child(key).child(index), names);
    }

    /** Whether a value or a part of it is the target of a track. */
    boolean animated(String key) {
        return names != null && names.isAnimated(place.child(key));
    }

    JsonValue json() {
        return new JsonValue.Obj(
                0, 0, values.keySet().toArray(String[]::new), values.values().toArray(JsonValue[]::new));
    }

    boolean isEmpty() {
        return values.isEmpty();
    }

    JsonObjectBuilder put(String key, JsonValue v) {
        if (key.length() > JsonTree.LONGEST_KEY) {
            throw SceneException.of(place.toString(), JsonTree.TOO_LONG);
        }
        values.put(wellFormed(key, key), v);
        return this;
    }

    JsonObjectBuilder text(String key, String v) {
        if (v.length() > JsonTree.LONGEST_TEXT) {
            throw SceneException.of(place.child(key).toString(), JsonTree.TOO_LONG);
        }
        return put(key, new JsonValue.Str(0, 0, wellFormed(v, key)));
    }

    private String wellFormed(String text, String key) {
        if (!Plain.isWellFormed(text)) {
            throw SceneException.of(place.child(key).toString(), JsonTree.NO_TEXT);
        }
        return text;
    }

    JsonObjectBuilder whole(String key, long v) {
        return put(key, new JsonValue.Num(0, 0, Long.toString(v)));
    }

    JsonObjectBuilder wholeUnless(long usual, String key, long v) {
        return v == usual && !animated(key) ? this : whole(key, v);
    }

    JsonObjectBuilder number(String key, double v) {
        return put(key, number(v));
    }

    JsonObjectBuilder numberUnless(double usual, String key, double v) {
        return Double.compare(v, usual) == 0 && !animated(key) ? this : number(key, v);
    }

    JsonObjectBuilder flagUnless(boolean usual, String key, boolean v) {
        return v == usual ? this : put(key, new JsonValue.Bool(0, 0, v));
    }

    /** Puts the name of an enum's constant in lower case, unless it is the usual one. */
    <E extends Enum<E>> JsonObjectBuilder wordUnless(E usual, String key, E v) {
        return v == usual ? this : text(key, Fields.word(v));
    }

    /** Puts a reference to a texture by name; a solid one without a name, or with tracks, as a colour. */
    JsonObjectBuilder texture(String key, Texture texture) {
        String name = names.of(texture);
        if (texture instanceof Texture.Solid solid && (name == null || animated(key))) {
            return color(key, solid.color());
        }
        return put(key, child(key).text("texture", name).json());
    }

    /** Puts a texture as {@link #texture}, if there is one. */
    JsonObjectBuilder textureIfPresent(String key, Optional<Texture> texture) {
        return texture.isPresent() ? texture(key, texture.get()) : this;
    }

    /** Puts the name of a texture that has one. */
    JsonObjectBuilder textureName(String key, Texture texture) {
        return text(key, names.of(texture));
    }

    /** The name of a material at this place; null if it must be written as an object. */
    String nameOf(Material m) {
        return names.isAnimated(place) ? null : names.of(m);
    }

    /** Puts an amount: a number, or a reference to its texture. */
    JsonObjectBuilder amount(String key, Texture.Amount amount) {
        if (!(amount instanceof Texture.Amount.Textured t)) {
            return number(key, ((Texture.Amount.Constant) amount).value());
        }
        JsonObjectBuilder reference = child(key)
                .textureName("texture", t.texture())
                .wordUnless(Texture.Amount.Channel.MEAN, "channel", t.channel())
                .numberUnless(1, "factor", t.factor());
        return put(key, reference.json());
    }

    JsonObjectBuilder amountUnless(double usual, String key, Texture.Amount amount) {
        return amount instanceof Texture.Amount.Constant c ? numberUnless(usual, key, c.value()) : amount(key, amount);
    }

    JsonObjectBuilder file(String key, Path file) {
        return text(key, names.of(file));
    }

    /** Puts the file of a mesh, and the processing of that file. */
    JsonObjectBuilder meshFile(String key, Mesh mesh) {
        Optional<String> whole = names.of(mesh.triangles());
        if (whole.isPresent()) {
            return text(key, whole.get());
        }
        MeshFiles.Origin origin = mesh.origin()
                .orElseThrow(() -> SceneException.of(
                        place.toString(), "is a mesh that lies in no file, which scene files cannot hold"));
        text(key, names.of(origin.file()));
        if (!origin.part().isEmpty()) {
            text("part", origin.part());
        }
        return wordUnless(MeshFiles.Origin.Normals.FILE, "normals", origin.normals())
                .numberUnless(180, "crease", origin.crease());
    }

    /** Puts three rows of four numbers; the last ones of the rows are exact. */
    JsonObjectBuilder matrix(String key, Transform.Matrix m) {
        Vec3[] rows = {m.row0(), m.row1(), m.row2()};
        List<JsonValue> all = new ArrayList<>();
        for (int k = 0; k < 3; k++) {
            all.addAll(List.of(number(rows[k].x()), number(rows[k].y()), number(rows[k].z())));
            all.add(exact(place.child(key).child(all.size()), m.offset().component(k)));
        }
        return put(key, JsonValue.Arr.of(all));
    }

    JsonObjectBuilder vector(String key, Vec3 v) {
        return put(key, JsonValue.Arr.of(List.of(number(v.x()), number(v.y()), number(v.z()))));
    }

    JsonObjectBuilder vectorUnless(Vec3 usual, String key, Vec3 v) {
        return v.equals(usual) && !animated(key) ? this : vector(key, v);
    }

    JsonObjectBuilder point(String key, ExactPoint p) {
        return put(key, json(place.child(key), p));
    }

    JsonObjectBuilder points(String key, ExactPoint... points) {
        List<JsonValue> items = new ArrayList<>();
        for (ExactPoint p : points) {
            items.add(json(place.child(key).child(items.size()), p));
        }
        return put(key, JsonValue.Arr.of(items));
    }

    JsonObjectBuilder color(String key, Color c) {
        return put(key, color(c, animated(key)));
    }

    JsonObjectBuilder colorUnless(Color usual, String key, Color c) {
        return c.equals(usual) && !animated(key) ? this : color(key, c);
    }

    JsonObjectBuilder colors(String key, List<Color> colors) {
        boolean asNumbers = animated(key);
        return put(
                key,
                JsonValue.Arr.of(colors.stream().map(c -> color(c, asNumbers)).toList()));
    }

    /** Puts linear light as three numbers. */
    JsonObjectBuilder linear(String key, Rgb c) {
        return put(key, bands(c));
    }

    /** Puts a single number if all bands are equal and no track targets one of them, else three numbers. */
    JsonObjectBuilder bands(String key, Rgb v) {
        boolean same = Double.compare(v.r(), v.g()) == 0 && Double.compare(v.g(), v.b()) == 0;
        JsonObjectBuilder inside = child(key);
        return same && !inside.animated("0") && !inside.animated("1") && !inside.animated("2")
                ? number(key, v.r())
                : linear(key, v);
    }

    JsonObjectBuilder bandsUnless(Rgb usual, String key, Rgb v) {
        return v.equals(usual) && !animated(key) ? this : bands(key, v);
    }

    JsonObjectBuilder wavelengths(String key, Material.WavelengthBand band) {
        return put(key, JsonValue.Arr.of(List.of(number(band.low()), number(band.high()))));
    }

    private static JsonValue bands(Rgb c) {
        return JsonValue.Arr.of(List.of(number(c.r()), number(c.g()), number(c.b())));
    }

    private static JsonValue color(Color color, boolean asNumbers) {
        if (color instanceof Rgb linear) {
            return new JsonValue.Obj(0, 0, new String[] {"linear"}, new JsonValue[] {bands(linear)});
        }
        DisplayRgb c = color.display();
        int r = (int) Math.rint(c.r() * 255);
        int g = (int) Math.rint(c.g() * 255);
        int b = (int) Math.rint(c.b() * 255);
        if (!asNumbers && DisplayRgb.ofBytes(r, g, b).equals(c)) {
            String hex = Integer.toHexString(1 << 24 | r << 16 | g << 8 | b).substring(1);
            return new JsonValue.Str(0, 0, "#" + hex);
        }
        return JsonValue.Arr.of(List.of(number(c.r()), number(c.g()), number(c.b())));
    }

    private static JsonValue number(double v) {
        return new JsonValue.Num(0, 0, Numbers.text(v));
    }

    private static JsonValue json(JsonPointer place, ExactPoint p) {
        List<JsonValue> items = new ArrayList<>(3);
        for (int k = 0; k < 3; k++) {
            items.add(exact(place.child(k), p.component(k)));
        }
        return JsonValue.Arr.of(items);
    }

    private static JsonValue exact(JsonPointer place, BigDecimal v) {
        long exponent = (long) v.precision() - v.scale();
        boolean hopeless = Math.abs(exponent) > 2L * Numbers.LARGEST_EXPONENT;
        String text = hopeless ? v.toString() : Numbers.text(v);
        String objection = Numbers.objection(text);
        if (objection != null) {
            throw SceneException.of(place.toString(), objection);
        }
        return new JsonValue.Num(0, 0, text);
    }
}

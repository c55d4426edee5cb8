package enlightenment.scene.json;

import enlightenment.material.Composite;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.scene.json.tree.JsonValue;
import java.util.ArrayList;
import java.util.List;

/** Materials that are made of others. */
final class DetailedMaterials {
    private DetailedMaterials() {}

    static Material read(String type, Fields f) {
        if (type.equals("mix")) {
            return mix(f);
        }
        Material of = f.has("of") ? Materials.use(f.get("of"), f.at("of"), f.values()) : null;
        if (type.equals("mask")) {
            Texture.Amount map = Amounts.read(f, "map");
            return of == null || map == null ? null : f.make(() -> new Composite.Mask(of, map));
        }
        Texture map = texture(f, "map");
        double height = f.number("height", 0);
        if (of == null || map == null) {
            return null;
        }
        return f.make(() -> switch (type) {
            case "normalMap" -> new Composite.NormalMap(of, map);
            case "bump" -> new Composite.Bump(of, map, height);
            default -> throw Family.unknown(type);
        });
    }

    private static Material mix(Fields f) {
        List<Material> parts = new ArrayList<>();
        JsonValue v = f.get("materials");
        JsonValue.Arr a = v == null ? null : f.values().array(v, f.at("materials"), 2, "an array of two materials");
        for (int i = 0; a != null && i < 2; i++) {
            parts.add(Materials.use(a.get(i), f.at("materials").child(i), f.values()));
        }
        Texture.Amount weight = Amounts.read(f, "weight");
        return a == null || parts.contains(null) || weight == null
                ? null
                : f.make(() -> new Composite.Mix(parts.get(0), parts.get(1), weight));
    }

    private static Texture texture(Fields f, String key) {
        if (!f.has(key)) {
            return null;
        }
        if (!(f.get(key) instanceof JsonValue.Obj)) {
            f.problem(key, "must be {\"texture\": NAME}, not " + f.get(key).describe());
            return null;
        }
        Fields reference = Fields.of(f.get(key), f.at(key), PartKeys.TEXTURE_REFERENCE, f.values());
        return reference == null || !reference.has("texture") ? null : Textures.ofSurface(reference);
    }

    /** A material, written as its name or as an object. */
    static JsonValue json(Material m, JsonObjectBuilder p) {
        String name = p.nameOf(m);
        if (name != null) {
            return new JsonValue.Str(0, 0, name);
        }
        Materials.FAMILY.write(m, p);
        return p.json();
    }

    static void write(Material value, JsonObjectBuilder p) {
        if (value instanceof Composite.Mix mix) {
            List<JsonValue> parts = new ArrayList<>();
            mix.parts().forEach(m -> parts.add(json(m, p.child("materials", parts.size()))));
            p.put("materials", JsonValue.Arr.of(parts)).amount("weight", mix.weight());
        } else if (value instanceof Composite.Mask mask) {
            p.put("of", json(mask.of(), p.child("of"))).amount("map", mask.map());
        } else if (value instanceof Composite.NormalMap normals) {
            p.put("of", json(normals.of(), p.child("of"))).texture("map", normals.map());
        } else if (value instanceof Composite.Bump bump) {
            p.put("of", json(bump.of(), p.child("of")))
                    .texture("map", bump.map())
                    .number("height", bump.height());
        } else {
            throw Family.unknown(value);
        }
    }
}

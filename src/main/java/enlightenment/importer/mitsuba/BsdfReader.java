package enlightenment.importer.mitsuba;

import enlightenment.color.Rgb;
import enlightenment.importer.support.UvMap;
import enlightenment.material.Composite;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Reads bsdfs that stand on others, and leaves those that do not to {@link SurfaceModels}. Each bsdf is read once. */
final class BsdfReader {
    private final SceneIndex scene;
    private final Map<XmlElement, Surface> read = new HashMap<>();

    BsdfReader(SceneIndex scene) {
        this.scene = scene;
    }

    /** The surface of a bsdf. */
    Surface surface(XmlElement bsdf) {
        Surface known = read.get(bsdf);
        if (known == null) {
            TextureReader textures = new TextureReader(scene);
            Optional<Material> material = new Reading(textures).material(bsdf, 0);
            known = new Surface(material, textures.map(), bsdf.type().equals("thindielectric"));
            read.put(bsdf, known);
            if (material.isPresent() && !bsdf.attribute("id").isEmpty()) {
                scene.draft().material(bsdf.attribute("id"), material.get());
            }
        }
        return known;
    }

    /** Of a shape that names none: a diffuse grey. */
    static Surface usual() {
        return new Surface(Optional.of(Material.Matte.of(Texture.of(Rgb.gray(0.5)))), UvMap.IDENTITY, false);
    }

    /** A surface while it is read, whose textures share one map of texture coordinates. */
    private final class Reading {
        /** Of references in circles. */
        private static final int MOST_DEPTH = 32;

        private final TextureReader textures;
        private final SurfaceModels models;

        Reading(TextureReader textures) {
            this.textures = textures;
            models = new SurfaceModels(scene, textures);
        }

        Optional<Material> material(XmlElement e, int depth) {
            if (depth > MOST_DEPTH) {
                throw e.failure("is a bsdf inside of itself");
            }
            Properties p = new Properties(e);
            Optional<Material> material =
                    switch (e.type()) {
                        case "twosided" -> twoSided(p, depth);
                        case "mask" -> mask(p, depth);
                        case "blendbsdf", "mixturebsdf" -> blend(p, depth);
                        case "bumpmap", "bump" -> bump(p, depth);
                        case "normalmap" -> normalMap(p, depth);
                        case "null" -> Optional.empty();
                        default -> Optional.of(models.material(p));
                    };
            p.ignore("id");
            scene.noteUnused(p);
            return material;
        }

        private List<XmlElement> parts(Properties p, int least) {
            List<XmlElement> parts = scene.inside(p.element(), "bsdf");
            if (parts.size() < least) {
                throw p.element().failure("needs " + least + (least == 1 ? " bsdf" : " bsdfs") + " inside");
            }
            return parts;
        }

        private Optional<Material> twoSided(Properties p, int depth) {
            List<XmlElement> parts = parts(p, 1);
            if (parts.size() > 1) {
                scene.note(p.element(), "the back of a twosided surface becomes like its front");
            }
            return material(parts.get(0), depth + 1);
        }

        private Optional<Material> opaque(Properties p, XmlElement part, int depth) {
            Optional<Material> m = material(part, depth + 1);
            if (m.isPresent() && (m.get() instanceof Glass || m.get() instanceof Material.Scattering)) {
                scene.note(
                        part,
                        part.described() + " inside of " + p.element().described() + " stands alone: only opaque"
                                + " surfaces can be parts of others");
            }
            return m;
        }

        private boolean isOpaque(Optional<Material> m) {
            return m.isPresent() && !(m.get() instanceof Glass) && !(m.get() instanceof Material.Scattering);
        }

        private Optional<Material> mask(Properties p, int depth) {
            Optional<Material> of = opaque(p, parts(p, 1).get(0), depth);
            Texture opacity =
                    p.find("opacity").map(e -> textures.texture(e, true)).orElse(Texture.of(Rgb.gray(0.5)));
            return isOpaque(of) ? Optional.of(new Composite.Mask(of.get(), opacity)) : of;
        }

        private Optional<Material> blend(Properties p, int depth) {
            List<XmlElement> parts = parts(p, 2);
            Optional<Material> first = opaque(p, parts.get(0), depth);
            Optional<Material> second = opaque(p, parts.get(1), depth);
            if (parts.size() > 2) {
                scene.note(p.element(), "only the first two bsdfs of a mixture count");
            }
            Texture weight = p.element().type().equals("blendbsdf") ? weight(p) : Texture.of(Rgb.gray(share(p)));
            if (first.isEmpty() && isOpaque(second)) {
                return Optional.of(new Composite.Mask(second.get(), weight));
            }
            return isOpaque(first) && isOpaque(second)
                    ? Optional.of(new Composite.Mix(first.get(), second.get(), weight))
                    : first.isPresent() ? first : second;
        }

        private Texture weight(Properties p) {
            return p.find("weight").map(e -> textures.texture(e, true)).orElse(Texture.of(Rgb.gray(0.5)));
        }

        /** The second weight of 0.6's mixture, as a share of both. */
        private double share(Properties p) {
            Optional<XmlElement> e = p.find("weights");
            double[] w = e.map(x -> Properties.numbers(x, x.attribute("value"))).orElse(new double[] {1, 1});
            double sum = w.length < 2 ? 0 : w[0] + w[1];
            if (!(sum > 0) || w[0] < 0 || w[1] < 0) {
                throw p.element().failure("must have weights that are not negative, one for each bsdf");
            }
            if (sum != 1) {
                scene.note(p.element(), "weights of a mixture are made to add up to 1");
            }
            return w[1] / sum;
        }

        private Optional<Material> bump(Properties p, int depth) {
            Optional<Material> of = opaque(p, parts(p, 1).get(0), depth);
            Optional<Texture> map = relief(p, "texture");
            double scale = p.number("scale", 1);
            p.ignore("use_shadowing_function", "flip_invalid_normals");
            if (map.isPresent() && isOpaque(of)) {
                return Optional.of(new Composite.Bump(of.get(), map.get(), scale));
            }
            return of;
        }

        private Optional<Material> normalMap(Properties p, int depth) {
            Optional<Material> of = opaque(p, parts(p, 1).get(0), depth);
            Optional<Texture> map = relief(p, "normalmap");
            p.ignore("use_shadowing_function", "flip_invalid_normals");
            if (map.isPresent() && isOpaque(of)) {
                Texture.File file = (Texture.File) map.get();
                if (file.encoding() != Texture.Encoding.LINEAR) {
                    scene.note(p.element(), "a normal map without raw is read as linear numbers");
                }
                return Optional.of(new Composite.NormalMap(
                        of.get(), new Texture.File(file.file(), file.filter(), Texture.Encoding.LINEAR)));
            }
            return of;
        }

        /** The picture of a relief. Its name does not matter: it is the only texture. */
        private Optional<Texture> relief(Properties p, String name) {
            List<XmlElement> found = scene.inside(p.element(), "texture");
            p.ignore(name);
            found.forEach(e -> p.ignore(e.name()));
            Optional<Texture> map = found.stream().findFirst().map(e -> textures.texture(e, false));
            if (map.isPresent() && map.get() instanceof Texture.File) {
                return map;
            }
            scene.note(p.element(), p.element().described() + " without a picture is left out");
            return Optional.empty();
        }
    }
}

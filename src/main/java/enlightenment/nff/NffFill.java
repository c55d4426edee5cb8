package enlightenment.nff;

import enlightenment.color.DisplayRgb;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.material.Texture;

/**
 * An {@code f} entity.
 *
 * @param color its colour
 * @param diffuse Kd
 * @param specular Ks
 * @param transmittance T
 * @param indexOfRefraction only used where T is greater than 0
 */
record NffFill(DisplayRgb color, double diffuse, double specular, double transmittance, double indexOfRefraction) {
    /** What things are made of before the first fill; the format leaves it open. */
    static final NffFill DEFAULT = new NffFill(DisplayRgb.WHITE, 1, 0, 0, 1);

    /** Glass where light passes, a mirror where nothing is diffuse but something is reflected, otherwise matte. */
    Material material(NffToken at, Notes notes) {
        Texture texture = Texture.of(color);
        if (transmittance > 0) {
            return glass(texture, at, notes);
        }
        if (diffuse == 0 && specular > 0) {
            if (specular != 1) {
                notes.add(at, "Ks " + show(specular) + " is not used: a mirror shows its colour as written");
            }
            return Material.Mirror.of(texture);
        }
        if (specular > 0) {
            notes.add(at, "Ks " + show(specular) + " and Shine are not used: beside Kd > 0 the surface is matte");
        }
        if (diffuse != 1) {
            notes.add(at, "Kd " + show(diffuse) + " is not used: a matte surface shows its colour as written");
        }
        return Material.Matte.of(texture);
    }

    private Material glass(Texture texture, NffToken at, Notes notes) {
        if (transmittance > 1) {
            notes.add(at, "T " + show(transmittance) + " is taken as 1");
        }
        double index = indexOfRefraction;
        if (!(index > 0)) {
            notes.add(at, "index of refraction " + show(index) + " is taken as 1");
            index = 1;
        }
        if (specular > 0) {
            notes.add(at, "Ks " + show(specular) + " and Shine are not used: glass reflects only totally");
        }
        double share = Math.min(transmittance, 1);
        if (share < 1 && diffuse != 1) {
            notes.add(at, "Kd " + show(diffuse) + " is not used: the opaque share of glass is 1 - T");
        }
        return new Glass(texture, index, share, 0, true);
    }

    /** As people write it: 1, not 1.0. */
    private static String show(double v) {
        return v == Math.rint(v) && Math.abs(v) < 1e15 ? Long.toString((long) v) : Double.toString(v);
    }
}

package enlightenment.physical;

import enlightenment.material.Texture;

/** Amounts where a path is. */
final class NaiveAmount {
    private NaiveAmount() {}

    /** The number at a hit. */
    static Texture.Amount at(Texture.Amount amount, NaiveScene.Hit hit) {
        if (!(amount instanceof Texture.Amount.Textured t)) {
            return amount;
        }
        double[] c = NaiveColors.of(t.texture(), hit.surface().shape(), hit.point());
        double mean = (c[0] + c[1] + c[2]) / 3;
        int band = t.channel().ordinal() - 1;
        return Texture.Amount.of(t.factor() * (band < 0 ? mean : c[band]));
    }

    /** The square of an amount that is a number. */
    static double squared(Texture.Amount amount) {
        double value = ((Texture.Amount.Constant) amount).value();
        return value * value;
    }
}

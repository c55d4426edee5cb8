package enlightenment.world.material;

import enlightenment.color.Rgb;
import enlightenment.material.Texture;

/**
 * A textured number as rendering reads it. Immutable.
 *
 * @param map the texture
 * @param channel the component of its colours that is the number
 * @param factor of that component
 */
public record AmountLookup(TextureLookup map, Texture.Amount.Channel channel, double factor) {

    /** A constant amount. */
    public static AmountLookup of(Texture.Amount.Constant amount) {
        return mean(new TextureLookup(Texture.of(Rgb.gray(amount.value())), null, true));
    }

    /** The mean of a texture's components. */
    static AmountLookup mean(TextureLookup map) {
        return new AmountLookup(map, Texture.Amount.Channel.MEAN, 1);
    }

    /** The amount of a colour. */
    double of(double[] rgb) {
        return factor
                * switch (channel) {
                    case MEAN -> (rgb[0] + rgb[1] + rgb[2]) / 3;
                    case RED -> rgb[0];
                    case GREEN -> rgb[1];
                    case BLUE -> rgb[2];
                };
    }

    /** A text that is equal for amounts that are equal everywhere. */
    String look() {
        return map.look() + (channel == Texture.Amount.Channel.MEAN && factor == 1 ? "" : " " + channel + " " + factor);
    }
}

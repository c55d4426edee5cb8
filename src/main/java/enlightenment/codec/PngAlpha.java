package enlightenment.codec;

import java.io.IOException;
import java.util.Optional;

/** How opaque pixels of a PNG file are: by their last sample, or by what the chunk tRNS says of palettes and single colours (11.3.2.1). */
final class PngAlpha {
    private final int depth;
    private final int channels;
    private final boolean isPalette;

    /** Opacities of the first colours of the palette; null without a palette. */
    private final byte[] opacities;

    /** The samples of the transparent colour; null where pixels have an opacity of their own. */
    private final int[] transparent;

    private PngAlpha(PngReader png, byte[] opacities, int[] transparent) {
        depth = png.depth;
        channels = png.channels();
        isPalette = png.isPalette();
        this.opacities = opacities;
        this.transparent = transparent;
    }

    /**
     * That of a file.
     *
     * @param chunk the content of tRNS, or null
     * @return empty if all of it is opaque
     */
    static Optional<PngAlpha> of(PngReader png, byte[] chunk) throws IOException {
        int channels = png.channels();
        if (channels == 2 || channels == 4) {
            return Optional.of(new PngAlpha(png, null, null));
        }
        if (chunk == null) {
            return Optional.empty();
        }
        if (png.isPalette()) {
            return Optional.of(new PngAlpha(png, chunk, null));
        }
        if (chunk.length != 2 * channels) {
            throw new IOException("its transparent colour has " + chunk.length + " bytes");
        }
        int[] samples = new int[channels];
        for (int c = 0; c < channels; c++) {
            samples[c] = PngPixels.sample(chunk, 0, c, 16);
        }
        return Optional.of(new PngAlpha(png, null, samples));
    }

    /** The opacity of the pixel in a column of a row: up to 255, or 65535 where samples have 16 bits. */
    int of(byte[] row, int from, int column) {
        int first = column * channels;
        if (isPalette) {
            int index = PngPixels.sample(row, from, column, depth);
            return index < opacities.length ? opacities[index] & 255 : 255;
        }
        if (transparent == null) {
            return PngPixels.sample(row, from, first + channels - 1, depth);
        }
        for (int c = 0; c < channels; c++) {
            if (PngPixels.sample(row, from, first + c, depth) != transparent[c]) {
                return depth == 16 ? 65535 : 255;
            }
        }
        return 0;
    }
}

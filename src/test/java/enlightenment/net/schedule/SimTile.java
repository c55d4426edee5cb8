package enlightenment.net.schedule;

import enlightenment.file.ContentHash;
import enlightenment.net.job.TileData;
import enlightenment.sampling.Hash;

/** A tile as a number: what an honest machine makes of it, or something else. */
record SimTile(ContentHash hash) implements TileData {
    private static final byte[] NOTHING = {};

    static SimTile right(int tile) {
        return new SimTile(new ContentHash(tile, Hash.mix(tile), 0, 0));
    }

    static SimTile wrong(int tile, long how) {
        return new SimTile(new ContentHash(tile, Hash.mix(tile), 1, how));
    }

    @Override
    public byte[] bytes() {
        return NOTHING;
    }
}

package enlightenment.engine;

import java.nio.ByteBuffer;
import java.util.Optional;

/** Units of both kinds: each has the form of its kind. */
final class MixedForm extends ResultForm {
    private final ResultForm batches;
    private final ResultForm tiles;

    MixedForm(WorkUnits units, int kinds, ResultForm batches, ResultForm tiles) {
        super(units, kinds);
        this.batches = batches;
        this.tiles = tiles;
    }

    private ResultForm of(int unit) {
        return units.isBatch(unit) ? batches : tiles;
    }

    @Override
    int longest(int unit) {
        return of(unit).longest(unit);
    }

    @Override
    ByteBuffer make(int unit, UnitWork work, ResultHeader header) {
        return of(unit).make(unit, work, header);
    }

    @Override
    ByteBuffer grow(int unit, UnitWork work, ResultHeader header, byte[] before) {
        return of(unit).grow(unit, work, header, before);
    }

    @Override
    boolean grows(int unit, UnitWork work, byte[] before) {
        return of(unit).grows(unit, work, before);
    }

    @Override
    Optional<String> problem(int unit, byte[] bytes) {
        return of(unit).problem(unit, bytes);
    }

    @Override
    void put(PictureFilm film, int unit, byte[] bytes) {
        of(unit).put(film.part(unit), unit, bytes);
    }

    @Override
    void remove(PictureFilm film, int unit, ResultStore store) {
        of(unit).remove(film.part(unit), unit, store);
    }

    @Override
    boolean needsStore() {
        return true;
    }
}

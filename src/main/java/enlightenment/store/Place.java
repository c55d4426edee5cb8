package enlightenment.store;

import java.sql.PreparedStatement;
import java.sql.SQLException;

/** The key of a result: a render by its id, a plan and a unit of it by their numbers. */
record Place(String render, int pass, int tile) {
    /** The condition that {@link #set} fills. */
    static final String CONDITION = "render_id = ? AND pass = ? AND tile = ?";

    /** Sets three parameters; returns the number of the next. */
    int set(PreparedStatement statement, int first) throws SQLException {
        statement.setString(first, render);
        statement.setInt(first + 1, pass);
        statement.setInt(first + 2, tile);
        return first + 3;
    }

    @Override
    public String toString() {
        return "unit " + tile + " of pass " + pass;
    }
}

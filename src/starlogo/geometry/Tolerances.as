package starlogo.geometry
{
    /**
     * The engine's tolerances. Each says what it limits, in which unit, and what happens if it is smaller or larger.
     *
     * <p>Nearly all are relative, so games of any scale behave in the same way. They come from two rounding errors: 1.1e-16 relative for a
     * Number, and 6e-8 relative for Flash Player's single-precision Matrix3D.</p>
     *
     * <p>They stand in groups: first those of all packages, from numbers over shapes that touch to contacts and motions; then those of one package each,
     * from convex shapes over models to hulls and fits. What a class chooses for a search of its own, such as the size of a probe or a slack of bounds,
     * stands in that class.</p>
     */
    public final class Tolerances
    {
        // Numbers and matrices: what is rounded in each of them.

        /**
         * The rounding error of a computed position or distance, as a fraction of the coordinates. Smaller: two structures that touch to
         * the last bit may get extents that do not overlap. Larger: extents are wider, and more pairs are tested.
         */
        public static const ROUNDING:Number = 1e-14;

        /**
         * The difference up to which two numbers from single-precision matrices count as equal, as a fraction of the largest. An Away3D
         * object's three scales are such numbers. Smaller than 5e-7: objects that were loaded with a matrix are refused. Larger: objects
         * of non-uniform scale pass, and the drawn object differs from the shape that collides.
         */
        public static const SINGLE_PRECISION:Number = 1e-5;

        /**
         * How much the dot products of a rotation's columns, or of a box's axes, may differ from 1 and 0. Of a matrix with one scale, the columns
         * divided by it are compared. Smaller than 5e-7: matrices are refused that Flash Player has rounded to single precision. Larger: a scaled
         * matrix passes for a rotation, and shear and non-uniform scale go unnoticed.
         */
        public static const ORTHONORMALITY:Number = 1e-5;

        /**
         * The number up to which lengths, heights and determinants are rounding, where shapes have a size of about 1. Smaller: rounding
         * decides how a hull loses corners, and flat sides of a hull have edges inside. Larger: short edges and shallow ones are lost.
         */
        public static const UNIT_ROUNDING:Number = 1e-12;

        // How near two shapes have to be to touch: the numbers of Touching.

        /**
         * The factor on the distance at which two structures touch: 1 plus the rounding of a test in several steps. It must be at least 1 +
         * 4 SURFACES. Smaller: rotated structures that touch do not collide. Larger: structures with a gap collide.
         */
        public static const TOUCHING:Number = 1 + 4e-14;

        /**
         * The gap across which shapes touch because their positions are rounded, as a fraction of the sum of the absolute values of all six
         * coordinates. Every collision system has this rule, for standing, sweeping and questions. Smaller than 2.3e-16: shapes at decimal
         * coordinates that touch do not collide. Larger: far from the origin, shapes with a gap collide.
         */
        public static const PLACES:Number = 6e-16;

        /**
         * The gap across which the surfaces of two models touch, as a fraction of the sum of the radii of spheres around both. The nodes of
         * hierarchies and the fitted boxes and capsules are enlarged by it. Smaller than 2e-15: rotated surfaces that touch do not collide.
         * Larger: surfaces with a gap collide.
         */
        public static const SURFACES:Number = 1e-14;

        /**
         * The rounding of the distance of two convex cores, as a fraction of the sum of their bounding radii. It is part of the distance at which they
         * touch: see Touching. Smaller than 4e-16: shapes that touch do not collide if one of them is much larger than the gaps of the two. Larger:
         * shapes with a gap collide.
         */
        public static const CORES:Number = 1e-15;

        // Quick tests, which come before the deciding test, and the boxes by which shapes are found: how much wider these are.

        /**
         * The factor that enlarges the shapes of quick tests, which come before the deciding test. Smaller than 1 + 1e-14: because of
         * rounding, quick tests may separate shapes that touch. Larger: quick tests decide fewer pairs.
         */
        public static const OUTER:Number = 1 + 1e-12;

        /**
         * Questions find an agent, and a structure's node meets others, by a box that is larger by this fraction of the size. Smaller than
         * 1e-14: agents that touch because of rounding may not be found. Larger: more agents are tested.
         */
        public static const EXTENTS:Number = 1e-13;

        /**
         * The boxes of EXTENTS are also enlarged by this factor times the gap of PLACES for the agent's position. Smaller than 2: agents
         * that touch by PLACES may not be found. Larger: more agents are tested.
         */
        public static const EXTENTS_GAPS:Number = 100;

        // Directions: when two are parallel, and when one is upright.

        /**
         * The squared sine of the angle below which two directions are nearly parallel. Their products are then computed from cross
         * products, where no digits cancel. Smaller: answers lose digits, because their error is 1e-16 divided by the sine of the angle.
         * Larger: more pairs take the slower computation, with the same answers.
         */
        public static const NEARLY_PARALLEL:Number = 1e-6;

        /**
         * The squared sine of the angle below which two directions are parallel. Smaller: rounding gives parallel directions a cross
         * product. Larger than 1e-20: boxes collide across a gap of the angle times their length.
         */
        public static const PARALLEL:Number = 1e-28;

        /**
         * The squared sine of the angle to z within which an axis counts as upright. A contact's normal that is perpendicular to an
         * upright axis is along x. A normal that is perpendicular to another axis points upwards as far as possible. Smaller than 1e-14:
         * that normal has no digits left. Larger: normals jump at axes that lean more.
         */
        public static const UPRIGHT:Number = 1e-6;

        // Contacts and times of impact: what rounding leaves certain in them.

        /**
         * The least sine of an angle between directions of contacts that rounding leaves certain. Edges within this angle count as parallel to
         * each other or to a face. As a fraction of the structures' size it is a length: a gap that is longer has a certain direction, so the
         * normal is along it, and corners whose depths differ by less touch together. Smaller: normals have an error of 1e-16 divided by it.
         * Larger: depths have an error of that fraction.
         */
        public static const DIRECTION:Number = 1e-9;

        /**
         * As a length, DIRECTION for the gaps that the package convex finds. They are made perpendicular to the edges and faces that they end at, so
         * shorter ones have a certain direction: the normal of the contact, if the cores are farther apart than this fraction of their bounding radii.
         * Smaller than 1e-12: rounding turns the normal by more than 4e-4. Larger: depths have an error of that fraction.
         */
        public static const PERPENDICULAR_GAP:Number = 1e-11;

        /**
         * How far a contact's depth may be off, as a fraction of the larger of the two extents. If the two are moved apart by the depth
         * plus this, they do not touch. If they are moved apart by the depth minus this, they touch. Smaller than 1e-12: rounding errors
         * along directions nearly parallel to a surface are larger. Larger: contacts are less precise.
         */
        public static const SEPARATION:Number = 1e-9;

        /**
         * The largest difference between two computations of the same time of impact, as a fraction of the motion. Of the triangles that touch
         * within it, the one that the motion meets most squarely makes the contact. Smaller: because of rounding, a side that a motion
         * grazes may make the contact. Larger: a later touch may replace the first one.
         */
        public static const SAME_TIME:Number = 1e-9;

        // Motions and questions of agents.

        /**
         * The squared length up to which nothing stops a motion, in square patches. Smaller than 1e-300: squares have no digits left, and
         * directions are lost. Larger: an agent may move into another one by the square root of it.
         */
        public static const VANISHING:Number = 1e-290;

        /**
         * The sine of the angle by which a position may be outside of a cone's border and still be in the cone. Smaller than 1e-15:
         * rounding decides at the border. Larger: cones are wider by that angle.
         */
        public static const CONE:Number = 2e-14;

        // The closest points of two convex cores: the package convex.

        /**
         * The rounding of the difference of a point of one convex core and a point of the other, as a fraction of the bounding radii and of the
         * distance of their places: about four units in the last place. Smaller: the search for the closest points goes on among rounding errors.
         * Larger: it ends too early, with an error of that fraction.
         */
        public static const CORE_POINTS:Number = 4e-16;

        /**
         * The squared height of a triangle over its longest edge, as a fraction of that edge squared, below which a triangle between two convex
         * cores counts as its edges. It is smaller than FLAT_TRIANGLE, because a point in a needle has more digits than the needle's normal. Smaller:
         * the height of a needle is a rounding error, and distances from it are wrong. Larger: the nearest point of a narrow triangle is taken from its
         * edges, and is farther by its height.
         */
        public static const NARROW_TRIANGLE:Number = 1e-28;

        // A model's triangles, the surface that they make, and its tree: the packages solid and hierarchy.

        /**
         * The squared height of a triangle over its longest edge below which the triangle is flat, as a fraction of that edge squared. A flat
         * triangle has no plane, and no side. Smaller: the normal of a needle is a rounding error. Larger: needles lose their sides.
         */
        public static const FLAT_TRIANGLE:Number = 1e-24;

        /**
         * The distance below which corners of triangles count as one for the surface as a whole, as a fraction of the model's extent. ROUNDING
         * of the largest coordinate is added. Smaller than 2.1e-7: seams between corners that were rounded to single precision stay open,
         * and the model has no inside. Larger: small holes are closed.
         */
        public static const WELDING:Number = 2.5e-7;

        /**
         * How much larger a hierarchy's nodes are than the nodes of the next level, as a fraction of the model's radius. Smaller than
         * 1e-15: because of rounding, children may touch something that their parents do not touch, so a greater depth may find more
         * collisions than a smaller depth. Larger: nodes are larger, by 63 times that fraction at the root.
         */
        public static const NESTING:Number = 2e-15;

        /**
         * From this level on, a hierarchy's nodes are not larger than the nodes of the next level: see NESTING. Smaller: below that
         * level, a greater depth may find more collisions than a smaller depth. Larger: all nodes are larger, by NESTING for each level.
         */
        public static const NESTED_LEVELS:int = 64;

        // Convex hulls: the folder hull, and the hulls of the package fitting.

        /**
         * The thickness up to which vertices count as lying in a plane, on a line or in one place, as a fraction of their extent. Smaller:
         * the rounding of a flat model counts as a shape. Larger: boxes around thin models are looser.
         */
        public static const HULL_FLAT:Number = 1e-12;

        /**
         * This fraction of the largest coordinate is added to the thickness that HULL_FLAT allows. Smaller: a flat model far from the
         * origin counts as a solid one. Larger: a thin model far from the origin counts as a flat one.
         */
        public static const HULL_ROUNDING:Number = 1e-14;

        /**
         * The share of their axis-aligned box that vertices must fill to get a grid along the coordinate axes. Vertices that fill less
         * get a grid along axes of their own. Smaller: thin rotated models lose precision. Larger: models with flat sides along the axes
         * get a rotated grid, on which these sides are not exactly flat.
         */
        public static const HULL_THIN:Number = 0.02;

        /**
         * A vertex above a triangle of the hull belongs to the triangle's plane up to this distance, and may be as far beside the triangle, in steps of
         * the hull's grid (3e-8 of the extent). Smaller than 1.8: a flat side that is not along the axes keeps dozens of vertices that are not its
         * corners. Larger: hulls are coarser.
         */
        public static const HULL_COPLANAR:Number = 2;

        /**
         * The distance from a plane beyond which its computed sign is right, in steps of the hull's grid. Smaller than 1e-7: hulls may be
         * wrong. Larger: the slower, exact computation decides more often.
         */
        public static const HULL_CERTAIN:Number = 1e-6;

        // Structures that are fitted around a model: the package fitting.

        /**
         * How far a point may lie outside of a structure that contains it, as a fraction of the structure's largest extent from its
         * middle. Smaller than 2e-7: a structure may exclude a vertex that was transformed by the same single-precision matrix as the
         * structure. Larger: a fit may leave more of a model outside.
         */
        public static const CONTAINMENT:Number = 1e-6;

        /**
         * The fraction by which a box must be smaller than the one before to replace it. Smaller: rounding chooses between rotations that
         * are equally good. Larger: fits are looser by that fraction.
         */
        public static const FIT_TIE:Number = 1e-9;

        /**
         * How far a point may be outside of the smallest sphere through others, as a fraction of the squared radius. Smaller than 1e-14:
         * rounding may leave no sphere that holds all points. Larger: smallest spheres are larger by that fraction.
         */
        public static const BALL_SLACK:Number = 1e-12;

        /**
         * A point counts as lying in the plane, line or place of other points if less than this share of its squared distance is
         * perpendicular to it. No sphere is put through such points. Smaller: the search tries centres far away, which are rounding errors.
         * Larger: the smallest sphere of nearly flat points may be missed.
         */
        public static const BALL_SINGULAR:Number = 1e-13;

        /**
         * The search for the smallest sphere ends when the squared radius grows by no more than this fraction. Smaller: the search may never
         * end. Larger: other points may be outside of the last sphere, by up to the square root of this fraction of the radius.
         */
        public static const BALL_GAIN:Number = 1e-14;
    }
}

// This room finds structures around the vertices of a model. Each algorithm is a Fitter; its work on one model is a Fit, and a FitSession
// keeps what several of them share; minimal/ and hull/ are for single fitters. Read this file first, then NaiveSphereFitter and
// EnclosingStructures, and OrientedBoxFitter with its RotationSearch.
package starlogo.fitting
{
    import flash.errors.IllegalOperationError;
    import starlogo.bounding.BoundingStructure;

    /**
     * An algorithm that finds a bounding structure for a model (thesis §3.4). The structure encloses every vertex, to within 1e-6 of the
     * model's size. This holds for any vertices: for one or two, for vertices on a line or in a plane, and for repeated ones. Far from the
     * origin the coordinates themselves are rounded. There a vertex may also be outside by Tolerances.ROUNDING times the sum of its coordinates.
     *
     * <p>This is the abstract base class. Each algorithm is a subclass, which implements <code>findStructure()</code>, or
     * <code>fitting()</code> if it works in steps. Only vertices on the convex hull decide how tight a fit can be (thesis §3.4.2), so the
     * algorithms search with those. A FitSession computes the hull once for all fitters of the same vertices. The structures are then
     * measured over every vertex in double precision.</p>
     *
     * <p>Here is a client's own fitter, which finds its structure without steps:</p>
     *
     * <listing>
     * public class OriginSphereFitter extends Fitter
     * {
     *     override protected function findStructure(session:FitSession):BoundingStructure
     *     {
     *         var v:Vector.&lt;Number&gt; = session.vertices;
     *         var radius:Number = 0;
     *         for (var i:int = 0; i &lt; v.length; i += 3)
     *         {
     *             radius = Math.max(radius, new Vector3D(v[i], v[i + 1], v[i + 2]).length);
     *         }
     *         return new Sphere(new Vector3D(), radius);
     *     }
     * }
     * </listing>
     */
    public class Fitter
    {
        private var _signature:String;

        /**
         * For subclasses only.
         *
         * @param signature the value of <code>signature</code>; null or an empty text for none
         */
        public function Fitter(signature:String = null)
        {
            _signature = signature;
        }

        /**
         * The algorithm and its settings in a few words. Two fitters with the same signature find the same structures, so a FitSession computes
         * them once. If it is null or empty, the structures are not kept in a FitStore or a cooked file. A client's own fitter may have a signature, which
         * must change whenever its results do.
         */
        public function get signature():String
        {
            return _signature;
        }

        /**
         * Returns the work that finds a structure around a session's vertices. Subclasses that work in steps override it. The fitter's settings at the
         * time of this call are used.
         *
         * @param session the vertices and their hull. The Fit computes the hull before all other work
         * @return the work, not begun yet
         */
        public function fitting(session:FitSession):Fit
        {
            return new Fit(session, findStructure);
        }

        /**
         * Finds a structure around a session's vertices without steps. Subclasses that do not override <code>fitting()</code> implement it.
         *
         * @param session the vertices, and their hull
         */
        protected function findStructure(session:FitSession):BoundingStructure
        {
            throw new IllegalOperationError(this + " implements neither findStructure nor fitting");
        }

        /**
         * Finds a structure around vertices. For several fits of the same vertices <code>FitSession.structureOf()</code> is faster.
         *
         * @param vertices x, y, z of each vertex; not changed
         * @return a new structure, in the vertices' space and unit
         * @throws ArgumentError if the vertices are null or empty, if the number of coordinates is not a multiple of 3, or if one of them
         *     is not finite or beyond 1e60
         * @throws RangeError if the structure's size would be above 0 and below 1e-70
         */
        public final function fit(vertices:Vector.<Number>):BoundingStructure
        {
            return new FitSession(vertices).structureOf(this);
        }
    }
}

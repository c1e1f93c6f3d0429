package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.convex.ContactPoint;

    /**
     * Keeps how a ray or a moving body meets rows, until the answer of the question is known. It also keeps the RayHits or ShapeHits that no
     * list needs at present, for lists that need more.
     *
     * @private
     */
    public final class Hits
    {
        private var _found:Collector;
        private var _type:Class;
        private var _spare:Array = [];
        private var _contacts:Vector.<ContactPoint> = new Vector.<ContactPoint>();

        private var _triangles:Vector.<int> = new Vector.<int>();

        // By row: the index of its contact.
        private var _indices:Vector.<int> = new Vector.<int>();

        /**
         * @param found collects the rows that are met
         * @param type RayHit or ShapeHit
         */
        public function Hits(found:Collector, type:Class)
        {
            _found = found;
            _type = type;
        }

        /** Returns a contact for the row that was collected last. The caller writes to it. */
        public function newContact(row:int, triangle:int = -1):ContactPoint
        {
            if (_indices.length <= row)
            {
                _indices.length = row + 1;
            }
            var index:int = _found.count - 1;
            _indices[row] = index;
            if (index == _contacts.length)
            {
                _contacts.push(new ContactPoint());
            }
            _triangles[index] = triangle;
            return _contacts[index];
        }

        /** The number of the triangle that is met in a row of the answer; -1 if no triangle decides. */
        public function triangleOf(index:int):int
        {
            return _triangles[_indices[_found.rows[index]]];
        }

        /** Copies the point and the normal of a row of the answer. Returns its contact. */
        public function write(index:int, point:Vector3D, normal:Vector3D):ContactPoint
        {
            var from:ContactPoint = _contacts[_indices[_found.rows[index]]];
            point.setTo(from.x, from.y, from.z);
            normal.setTo(from.normalX, from.normalY, from.normalZ);
            return from;
        }

        /**
         * Makes a list have as many hits as an answer. It removes surplus hits one at a time, because V8 frees an array's memory if its length is
         * set to less.
         *
         * @param hits a list of hits of the type
         */
        public function fit(hits:Object, length:int):void
        {
            while (hits.length > length)
            {
                var hit:Object = hits.pop();
                if (hit != null)
                {
                    hit.agent = null;
                    _spare.push(hit);
                }
            }
            for (var i:int = 0; i < length; i++)
            {
                if (i == hits.length || hits[i] == null)
                {
                    var spare:Object = _spare.pop();
                    if (spare == null)
                    {
                        spare = new _type();
                    }
                    hits[i] = spare;
                }
            }
        }
    }
}

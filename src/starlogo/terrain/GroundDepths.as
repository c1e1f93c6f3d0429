package starlogo.terrain
{
    import flash.geom.Vector3D;
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.ConvexTriangle;
    import starlogo.intersection.DeepestPoint;
    import starlogo.intersection.contact.ContactPoint;

    use namespace engine;

    /** Finds the contacts of a standing piece of a model with the ground's triangles. Depths are returned as a search wants them: less is better. */
    internal final class GroundDepths
    {
        // How far from an edge the ground beside it is looked at, as a fraction of a cell and of the coordinates; and how far out, as a fraction of
        // that. Walls that are lower are not seen.
        private static const BESIDE:Number = 1e-6;
        private static const OF_PLACES:Number = 1e-12;
        private static const OUT:Number = 1 / 64;

        // Two ways have nearly the same direction if the cosine of their angle is larger.
        private static const SAME_WAY:Number = 0.98;

        // How far the place from which the ground beside an edge is looked at lies from the end of the edge.
        private static const FROM_END:Number = 1e-3;

        // The part of a depth that must be known to be needed.
        private static const NEEDED:Number = 0.8;

        /** The contact with the last triangle. */
        public var contact:ContactPoint = new ContactPoint();

        /** The length that any way out of the ground has at least, by the last triangle; 0 if it is not known. */
        public var needed:Number = 0;

        private var _piece:ConvexTriangle;
        private var _faces:GroundFaces;
        private var _edge:ContactPoint = new ContactPoint();
        private var _against:ContactPoint = new ContactPoint();
        private var _farthest:DeepestPoint = new DeepestPoint();
        private var _place:Vector3D;

        // The normals of the ways that were found.
        private var _xs:Vector.<Number> = new Vector.<Number>();
        private var _ys:Vector.<Number> = new Vector.<Number>();
        private var _zs:Vector.<Number> = new Vector.<Number>();
        private var _wayCount:int = 0;

        /**
         * @param piece the piece
         * @param faces has the current triangle, which the piece is set to
         */
        public function GroundDepths(piece:ConvexTriangle, faces:GroundFaces)
        {
            _piece = piece;
            _faces = faces;
        }

        /** Forgets all ways. */
        public function forgetWays():void
        {
            _wayCount = 0;
        }

        /** Remembers a way. */
        public function addWay(way:ContactPoint):void
        {
            _xs[_wayCount] = way.normalX;
            _ys[_wayCount] = way.normalY;
            _zs[_wayCount] = way.normalZ;
            _wayCount++;
        }

        /** Finds the depth behind the triangle's plane; Infinity if there was a way of nearly this direction. */
        public function findWay():Number
        {
            _piece.findBehind(contact);
            var isNew:Boolean = contact.depth >= -_piece.gap;
            for (var i:int = 0; i < _wayCount && isNew; i++)
            {
                isNew = contact.normalX * _xs[i] + contact.normalY * _ys[i] + contact.normalZ * _zs[i] < SAME_WAY;
            }
            return isNew ? contact.depth : Infinity;
        }

        /**
         * Finds the negative depth behind the triangle, if the piece's deepest point is there and about as deep in the ground.
         *
         * @param best the best result so far
         */
        public function findFace(best:Number, grid:HeightGrid):Number
        {
            var isUnder:Boolean = _piece.findBehind(contact);
            if (!isUnder || !(contact.depth >= _piece.gap - best || best == 0 && contact.depth >= -_piece.gap))
            {
                return Infinity;
            }
            findNeeded(grid);
            return needed >= NEEDED * contact.depth ? -contact.depth : Infinity;
        }

        /**
         * Finds the negative depth along the direction in which the piece and the triangle overlap least. If this direction does not lead out of
         * the ground, it is the depth behind the triangle's plane.
         */
        public function findEdge(best:Number, grid:HeightGrid):Number
        {
            var isUnder:Boolean = _piece.findBehind(contact);
            if (!(contact.depth >= _piece.gap - best || best == 0) || !_piece.touches())
            {
                return Infinity;
            }
            _piece.time = 0;
            _piece.findContact(_edge);
            if (isOutside(grid))
            {
                contact.copyFrom(_edge);
                return -contact.depth;
            }
            return isUnder ? -contact.depth : Infinity;
        }

        // Whether the normal at an edge leads out of the ground: the ground on the other side of the edge is not above the plane of the contact.
        // On a floor, the edges between its triangles have no normals other than the floor's.
        private function isOutside(grid:HeightGrid):Boolean
        {
            var cosine:Number = contact.normalX * _edge.normalX + contact.normalY * _edge.normalY + contact.normalZ * _edge.normalZ;
            var sine:Number = Math.sqrt(Math.max(0, 1 - cosine * cosine));
            if (sine < Tolerances.DIRECTION)
            {
                // a normal that points into the ground has been replaced by that of the face
                return _edge.depth >= contact.depth * (1 - Tolerances.DIRECTION) - _piece.gap;
            }
            // along the plane of the contact, away from the triangle, and a little out
            var by:Number = BESIDE * grid.cellWidth + OF_PLACES * (Math.abs(_faces.origin.x) + Math.abs(_faces.origin.y) + Math.abs(_faces.origin.z));
            var out:Number = by * (cosine / sine + OUT);
            var back:Number = by / sine;
            findEdgePlace(sine);
            grid.placeX = _faces.origin.x + _place.x + out * _edge.normalX - back * contact.normalX;
            grid.placeY = _faces.origin.y + _place.y + out * _edge.normalY - back * contact.normalY;
            grid.findHeight();
            return !(grid.height >= _faces.origin.z + _place.z + out * _edge.normalZ - back * contact.normalZ);
        }

        // Finds the place of the triangle that is farthest along the normal at the edge. If it is a corner, the place is a little way along the edge.
        private function findEdgePlace(sine:Number):void
        {
            var p:Vector.<Number> = _faces.corners;
            _against.setNormal(-_edge.normalX, -_edge.normalY, -_edge.normalZ);
            _farthest.findOfCorners(p, 9, _against);
            _place = _farthest.point;
            _against.setNormal(_edge.normalY * contact.normalZ - _edge.normalZ * contact.normalY, _edge.normalZ * contact.normalX - _edge.normalX * contact.normalZ,
                    _edge.normalX * contact.normalY - _edge.normalY * contact.normalX);
            var along:Number = _against.normalX * (p[0] + p[3] + p[6]) + _against.normalY * (p[1] + p[4] + p[7]) + _against.normalZ * (p[2] + p[5] + p[8]);
            _against.push(_place, FROM_END * (along / 3 - _against.along(_place)) / (sine * sine));
        }

        // Finds how long any way out of the ground is at least, because the piece's deepest point has to get out.
        private function findNeeded(grid:HeightGrid):void
        {
            var depth:Number = contact.depth;
            var reach:Number = depth / grid.cellWidth;
            var width:Number = grid.isBlocky ? 0.5 : 0;
            needed = 0;
            grid.placeX = _faces.origin.x + contact.x - depth / 2 * contact.normalX;
            grid.placeY = _faces.origin.y + contact.y - depth / 2 * contact.normalY;
            grid.findHeight();
            var z:Number = _faces.origin.z + contact.z - depth / 2 * contact.normalZ;
            var column:Number = (grid.placeX - grid.x) / grid.cellWidth;
            var row:Number = (grid.placeY - grid.y) / grid.cellWidth;
            if (!(grid.height > z) || column - reach < -width || row - reach < -width || column + reach > grid.columns - 1 + width
                    || row + reach > grid.rows - 1 + width)
            {
                return;
            }
            var high:Number = grid.height;
            var first:int = Math.floor(column - reach + width);
            var firstRow:int = Math.floor(row - reach + width);
            var last:int = Math.ceil(column + reach - width);
            var lastRow:int = Math.ceil(row + reach - width);
            grid.findAround(first, firstRow, last, lastRow);
            needed = grid.least - z;
            if (!grid.isBlocky)
            {
                var slopeX:Number = grid.stepX / grid.cellWidth;
                var slopeY:Number = grid.stepY / grid.cellWidth;
                needed = Math.max(needed, (high - z) / Math.sqrt(1 + slopeX * slopeX + slopeY * slopeY));
            }
            needed = Math.min(needed, depth);
        }
    }
}

package starlogo.terrain
{
    import starlogo.engine;
    import starlogo.intersection.ConvexTriangle;
    import starlogo.intersection.contact.ContactPoint;

    use namespace engine;

    /** Finds the contacts of a standing piece of a model with the ground's triangles. Depths are returned as a search wants them: less is better. */
    internal final class GroundDepths
    {
        // Two ways have nearly the same direction if the cosine of their angle is larger.
        private static const SAME_WAY:Number = 0.98;

        // How many gaps of a triangle the part of a contact may reach before its plane, because of rounding.
        private static const PART_GAPS:Number = 10;

        // The most ways that are found.
        private static const MOST_WAYS:int = 12;

        // The part of a depth that must be known to be needed.
        private static const NEEDED:Number = 0.8;

        /** The contact with the last triangle. */
        public var contact:ContactPoint = new ContactPoint();

        /** The length that any way out of the ground has at least, by the last triangle; 0 if it is not known. */
        public var needed:Number = 0;

        /** The number of ways since <code>beginWays()</code>. */
        public var wayCount:int = 0;

        /** Whether there is a part of the last contact. */
        public var hasPart:Boolean = false;

        private var _piece:ConvexTriangle;
        private var _faces:GroundFaces;
        private var _part:Vector.<Number> = new Vector.<Number>(9, true);
        private var _ways:Vector.<ContactPoint>;

        /**
         * @param piece the piece
         * @param faces has the current triangle, which the piece is set to
         */
        public function GroundDepths(piece:ConvexTriangle, faces:GroundFaces)
        {
            _piece = piece;
            _faces = faces;
        }

        /** Begins with a list of ways. */
        public function beginWays(ways:Vector.<ContactPoint>):void
        {
            _ways = ways;
            wayCount = 0;
        }

        /** Remembers the triangle as the part of the ground that the last contact is with. */
        public function keepPart():void
        {
            for (var i:int = 0; i < 9; i++)
            {
                _part[i] = _faces.corners[i];
            }
            hasPart = true;
        }

        /**
         * Adds the way out of the triangle's plane, if the piece and the part of the last contact are behind it. Of ways with nearly the same
         * direction, the shortest is kept.
         */
        public function addWay():void
        {
            _piece.findBehind(contact);
            if (!(contact.depth >= -_piece.gap && (!hasPart || isPartBehind())))
            {
                return;
            }
            for (var i:int = 0; i < wayCount; i++)
            {
                var way:ContactPoint = _ways[i];
                if (contact.normalX * way.normalX + contact.normalY * way.normalY + contact.normalZ * way.normalZ > SAME_WAY)
                {
                    if (contact.depth < way.depth)
                    {
                        way.copyFrom(contact);
                    }
                    return;
                }
            }
            if (wayCount < MOST_WAYS)
            {
                if (wayCount == _ways.length)
                {
                    _ways[wayCount] = new ContactPoint();
                }
                _ways[wayCount].copyFrom(contact);
                wayCount++;
            }
        }

        private function isPartBehind():Boolean
        {
            contact.measure(_part, 0, 9);
            var greatest:Number = contact.greatest;
            contact.measure(_faces.corners, 0, 3);
            return greatest <= contact.least + PART_GAPS * _piece.gap;
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

        /** Finds the negative depth along the direction in which the piece and the triangle overlap least. */
        public function findEdge(best:Number):Number
        {
            _piece.findBehind(contact);
            if (!(contact.depth >= _piece.gap - best || best == 0) || !_piece.touches())
            {
                return Infinity;
            }
            _piece.time = 0;
            _piece.findContact(contact);
            return -contact.depth;
        }

        // Finds how long any way out of the ground is at least, because the piece's deepest point has to get out.
        private function findNeeded(grid:HeightGrid):void
        {
            var depth:Number = contact.depth;
            needed = 0;
            grid.placeX = _faces.origin.x + contact.x - depth / 2 * contact.normalX;
            grid.placeY = _faces.origin.y + contact.y - depth / 2 * contact.normalY;
            grid.findHeight();
            var z:Number = _faces.origin.z + contact.z - depth / 2 * contact.normalZ;
            var border:Number = grid.isBlocky ? grid.cellWidth / 2 : 0;
            var left:Number = Math.min(grid.placeX - grid.x, grid.x + (grid.columns - 1) * grid.cellWidth - grid.placeX);
            var front:Number = Math.min(grid.placeY - grid.y, grid.y + (grid.rows - 1) * grid.cellWidth - grid.placeY);
            if (!(grid.height > z) || Math.min(left, front) + border < depth)
            {
                return;
            }
            var high:Number = grid.height;
            grid.reachX = grid.reachY = depth;
            grid.findAround();
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

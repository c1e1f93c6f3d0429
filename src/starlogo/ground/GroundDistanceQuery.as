package starlogo.ground
{
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.geometry.Tolerances;

    use namespace engine;

    /** Finds the distance and the closest points of a model and the ground. */
    internal final class GroundDistanceQuery
    {
        private var _pieces:GroundPieces;
        private var _nearest:GroundPoint = new GroundPoint();

        /** @param pieces of the model, where it stands */
        public function GroundDistanceQuery(pieces:GroundPieces)
        {
            _pieces = pieces;
        }

        /**
         * Finds how far the model and the ground are apart, and between which points.
         *
         * @param areTouching whether the two overlap. If so, a point of both is found
         * @param out receives the distance and the points, in the world
         */
        public function find(areTouching:Boolean, out:ClosestPoints):void
        {
            var box:GroundBox = _pieces.box;
            findNearest(out);
            if (!_pieces.hasTree)
            {
                _pieces.beginAt(_nearest);
                measure(out);
            }
            _pieces.begin(RelativeMotion.NONE, out.distance);
            while (_pieces.nextPiece())
            {
                measure(out);
            }
            if (areTouching)
            {
                // either the model's point is in the ground, or the surface's point is in the model
                var isUnder:Boolean = _pieces.grid.heightAt(out.aX + box.origin.x, out.aY + box.origin.y) - box.origin.z >= out.aZ;
                out.aX = out.bX = isUnder ? out.aX : out.bX;
                out.aY = out.bY = isUnder ? out.aY : out.bY;
                out.aZ = out.bZ = isUnder ? out.aZ : out.bZ;
            }
            out.settle(areTouching);
            out.place(box.origin);
        }

        // Finds the point of the grid that is nearest to the model's middle, seen from above. The model is at most as far as its farthest point is
        // from there, so the distance begins with that.
        private function findNearest(out:ClosestPoints):void
        {
            var box:GroundBox = _pieces.box;
            _pieces.placeBox();
            _nearest.x = box.x + box.origin.x;
            _nearest.y = box.y + box.origin.y;
            _pieces.grid.findNearest(_nearest);
            var x:Number = Math.abs(_nearest.x - box.origin.x - box.x) + box.halfX;
            var y:Number = Math.abs(_nearest.y - box.origin.y - box.y) + box.halfY;
            var z:Number = Math.abs(_nearest.height - box.origin.z - box.z) + box.halfZ;
            out.distance = Math.sqrt(x * x + y * y + z * z) * Tolerances.OUTER + Tolerances.SURFACES * _pieces.grid.cellWidth;
        }

        // Measures the distances of the piece and the triangles near it, and keeps the closest points.
        private function measure(out:ClosestPoints):void
        {
            while (_pieces.nextTriangle())
            {
                if (_pieces.pair.findCloser(out))
                {
                    _pieces.box.maxDistance = out.distance;
                }
            }
        }
    }
}

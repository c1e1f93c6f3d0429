package starlogo.queries.motion
{
    import flash.geom.Vector3D;
    import starlogo.convex.ContactPoint;
    import starlogo.data.IntList;

    /**
     * Moves a body as characters move, along what it meets or straight on: ShrunkSweep says what stops it, and RemainingMotion turns the rest. The body
     * ends a clearance before what stops it, so that the next motion begins free.
     *
     * <p>It returns how a motion ends. There is one result for slides and one for straight motions, and each is valid until the next motion of its kind.
     * That motion may begin at the place of the result.</p>
     *
     * @private
     */
    public final class Slider
    {
        // The least z of the normal of a horizontal floor, which has rounding errors.
        private static const HORIZONTAL_Z:Number = 1 - 1e-12;

        // In place of the least z of a floor's normal, for a slide that makes nothing a floor or a wall.
        private static const NO_FLOORS:Number = 0;

        // If the next row is met within this many slops, this is the same corner.
        private static const SAME_CORNER:Number = 4;

        // A normal is vertical if the square of its horizontal part is at most this. The rest is a rounding error.
        private static const VERTICAL_NORMAL:Number = 1e-20;

        // A slide turns at this many contacts at most.
        private static const MAX_CONTACTS:int = 8;

        /** Frees its motions from overlaps where they start. Others may use it between two motions. Read only. */
        public var depenetration:Depenetration = new Depenetration();

        /** Sweeps its motions. Others may use it between two motions. Read only. */
        public var sweep:ShrunkSweep = new ShrunkSweep(depenetration);

        // What remains of a slide.
        private var _remaining:RemainingMotion = new RemainingMotion();

        // A way straight up or down.
        private var _vertical:Vector3D = new Vector3D();

        // How a slide ends, and a straight motion.
        private var _slid:MotionResult = new MotionResult();
        private var _straight:MotionResult = new MotionResult();

        /**
         * Slides along all that it meets, wherever that leads.
         *
         * @param rows the rows that may be in its way
         * @param from where it begins
         * @param motion the whole motion
         */
        public function slide(body:MovingBody, rows:IntList, from:Vector3D, motion:Vector3D):MotionResult
        {
            return goOn(begin(body, rows, from, motion, Infinity, RemainingMotion.NO_FALL), motion, NO_FLOORS);
        }

        /**
         * Slides among the body's own rows up and down on floors, and along what is too steep for a floor as along an upright wall.
         *
         * @param minFloorNormalZ the least z of the normal of a floor
         * @param maxHorizontal the greatest length of its way on the ground plane. A floor can turn a motion up or down more level
         */
        public function slideOnFloors(body:MovingBody, from:Vector3D, motion:Vector3D, minFloorNormalZ:Number, maxHorizontal:Number):MotionResult
        {
            return goOn(begin(body, body.rows, from, motion, maxHorizontal, RemainingMotion.NO_FALL), motion, minFloorNormalZ);
        }

        /**
         * Slides among the body's own rows at one height. All that it meets is an upright wall, except of horizontal floors. So are the planes of overlaps
         * at the start.
         *
         * @param motion the whole motion, which is horizontal
         * @param maxLength the greatest length of its way
         */
        public function slideLevel(body:MovingBody, from:Vector3D, motion:Vector3D, maxLength:Number = Infinity):MotionResult
        {
            var first:Impact = begin(body, body.rows, from, motion, maxLength, RemainingMotion.NO_FALL);
            makePlanesUpright();
            return goOn(first, motion, HORIZONTAL_Z);
        }

        /**
         * Slides down like a fall among the body's own rows, as long as what it slides on is too steep to stand on.
         *
         * @param depth how far down at most
         * @param minFloorNormalZ the least z of the normal of what is not too steep
         * @param maxHorizontal how far sideways at most
         */
        public function slideDown(body:MovingBody, from:Vector3D, depth:Number, minFloorNormalZ:Number, maxHorizontal:Number):MotionResult
        {
            _vertical.z = -depth;
            var fallSlope:Number = Math.sqrt(1 - minFloorNormalZ * minFloorNormalZ) / minFloorNormalZ;
            return goOn(begin(body, body.rows, from, _vertical, maxHorizontal, fallSlope), _vertical, NO_FLOORS);
        }

        // Begins a slide. The last two parameters are those of RemainingMotion.begin(). Returns what stops it first, or null if nothing does or there are
        // planes.
        private function begin(body:MovingBody, rows:IntList, from:Vector3D, motion:Vector3D, maxHorizontal:Number, fallSlope:Number):Impact
        {
            _remaining.begin(motion, maxHorizontal, fallSlope);
            var first:Impact = sweep.begin(body, rows, from, _remaining.motion);
            _slid.wallRow = -1;
            _slid.row = -1;
            _slid.startsPenetrating = sweep.planes.count > 0;
            _slid.place.copyFrom(sweep.start);
            return first;
        }

        // Goes on with a slide from impact to impact. What is too steep for a floor is an upright wall.
        private function goOn(first:Impact, motion:Vector3D, minFloorNormalZ:Number):MotionResult
        {
            var result:MotionResult = _slid;
            var impact:Impact = first;
            if (result.startsPenetrating)
            {
                _remaining.beginCorner();
                impact = projectAndSweep(result.place);
            }
            // the planes from this index on belong to the corner where the body is
            var corner:int = sweep.planes.count;
            for (var contacts:int = 0; contacts < MAX_CONTACTS && impact != null; contacts++)
            {
                if (!isInCorner(impact))
                {
                    _remaining.beginCorner();
                    corner = sweep.planes.count;
                }
                var touchTime:Number = sweep.findTouchTime(impact, result.place, _remaining.motion);
                _remaining.advance(result.place, Math.max(touchTime + sweep.shrunk.clearance / impact.contact.along(_remaining.motion), 0));
                respondTo(impact, minFloorNormalZ, result);
                dropNeedlessPlanes(result.place, corner, sweep.planes.add(impact.contact, impact.row));
                impact = projectAndSweep(result.place);
            }
            if (impact == null)
            {
                _remaining.advance(result.place, 1);
            }
            result.fraction = _remaining.travelled < motion.length ? _remaining.travelled / motion.length : 1;
            return result;
        }

        // Turns what remains of the motion out of the planes. Returns what stops it then, or null.
        private function projectAndSweep(place:Vector3D):Impact
        {
            _remaining.project(sweep.planes);
            return sweep.findStoppingImpact(place, _remaining.motion);
        }

        /**
         * Computes a straight motion that ends a clearance before what stops it.
         *
         * @param rows the rows that may be in its way
         * @param from where it begins
         * @param motion the whole motion
         */
        public function moveStraight(body:MovingBody, rows:IntList, from:Vector3D, motion:Vector3D):MotionResult
        {
            var result:MotionResult = _straight;
            sweep.findStop(body, rows, from, motion, result);
            var end:Number = result.hasContact ? Math.max(result.fraction + sweep.shrunk.clearance / result.contact.along(motion), 0) : 1;
            ShrunkSweep.setAlong(sweep.start, motion, end, result.place);
            return result;
        }

        /** Computes a way straight up, or down if dz is less than 0: a straight motion among the body's own rows. */
        public function moveVertically(body:MovingBody, from:Vector3D, dz:Number):MotionResult
        {
            _vertical.z = dz;
            return moveStraight(body, body.rows, from, _vertical);
        }

        // Responds to what a slide meets. What is too steep for a floor becomes an upright wall. The rest of the motion climbs a floor. The result gets the
        // contact.
        private function respondTo(impact:Impact, minFloorNormalZ:Number, out:MotionResult):void
        {
            var contact:ContactPoint = impact.contact;
            if (!impact.isNormalFallback && (!out.hasContact || contact.normalZ > out.contact.normalZ))
            {
                out.contact.copyFrom(contact);
                out.row = impact.row;
            }
            if (minFloorNormalZ == NO_FLOORS)
            {
                return;
            }
            if (contact.normalZ < minFloorNormalZ)
            {
                out.wallRow = impact.row;
                makeUpright(contact);
            }
            else
            {
                _remaining.liftOverPlane(contact);
            }
        }

        // Turns a contact that is too steep into an upright wall. The rest of the motion becomes horizontal, because the slope would stop a motion up
        // or down.
        private function makeUpright(contact:ContactPoint):void
        {
            if (contact.normalX * contact.normalX + contact.normalY * contact.normalY > VERTICAL_NORMAL)
            {
                contact.setNormal(contact.normalX, contact.normalY, 0);
                contact.normalise();
                _remaining.flatten();
            }
        }

        // Turns the planes of what the body overlaps into upright walls, except of horizontal floors and ceilings.
        private function makePlanesUpright():void
        {
            for (var i:int = 0; i < sweep.planes.count; i++)
            {
                var plane:ContactPoint = sweep.planes.contacts[i];
                if (Math.abs(plane.normalZ) < HORIZONTAL_Z)
                {
                    makeUpright(plane);
                }
            }
        }

        // Removes planes of this corner that are not needed, but not the newest. At the edges of tiles, a contact's plane may belong to a side that the
        // next tile hides. A plane is removed if the motion meets nothing in this corner without it. Afterwards the rest of the motion has to be
        // projected again.
        private function dropNeedlessPlanes(place:Vector3D, corner:int, newest:int):void
        {
            for (var i:int = sweep.planes.count - 1; i >= corner; i--)
            {
                if (i != newest)
                {
                    _remaining.project(sweep.planes, i);
                    if (_remaining.motion.lengthSquared > 0 && !meetsInCorner(place))
                    {
                        sweep.planes.remove(i);
                    }
                }
            }
        }

        // Whether what remains of the motion is stopped in this corner.
        private function meetsInCorner(place:Vector3D):Boolean
        {
            var first:Impact = sweep.findFirstImpact(place, _remaining.motion);
            return first != null && isInCorner(first) && !sweep.shrunk.body.passesOneWay(first.row, first.contact);
        }

        // Whether the rest of the motion meets this in the corner where it begins.
        private function isInCorner(impact:Impact):Boolean
        {
            return impact.time * _remaining.motion.length < SAME_CORNER * sweep.shrunk.slop;
        }
    }
}

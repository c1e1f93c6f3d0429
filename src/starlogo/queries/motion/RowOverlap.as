package starlogo.queries.motion
{
    import flash.geom.Vector3D;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.data.IntList;
    import starlogo.engine;
    import starlogo.search.Body;
    import starlogo.search.ModelShape;
    import starlogo.search.pairs.GroundPairTests;
    import starlogo.search.pairs.PairTests;
    import starlogo.search.penetration.OverlapMiddle;

    use namespace engine;

    /**
     * Tells how a body overlaps a row at a place: with which contact, and how deep. It also finds the deepest overlap with several rows.
     *
     * @private
     */
    public final class RowOverlap
    {
        // A body that is this many times half of its extent inside of a structure is inside with room to spare. Two equal ones in one place are not.
        private static const WITH_ROOM:Number = 2.1;

        // A smaller copy of a row's body, and one of the contacts.
        private var _smaller:Body = new Body();
        private var _contact:ContactPoint = new ContactPoint();

        /**
         * Finds the contact of the whole body with a row that it touches.
         *
         * @param isSure true: the contact separates the two. False: a shallow contact of two of their parts is enough. The ground can be
         *     floor and wall at once, and a contact with one does not lead away from the other
         * @param out receives the contact
         * @return whether the contact is shallow
         */
        public function findContact(body:MovingBody, row:int, place:Vector3D, isSure:Boolean, out:ContactPoint):Boolean
        {
            var other:Body = body.bodyOf(row);
            var whole:Body = body.wholeAt(place);
            var shallow:Number = BodyCore.SHALLOW * body.extentWith(other);
            var pairTests:PairTests = body.pairTestsFor(whole, other);
            pairTests.findContactOfParts(whole, other, RelativeMotion.NONE, out);
            if (isSure || out.depth > shallow)
            {
                pairTests.separate(whole, other, RelativeMotion.NONE, out);
            }
            return out.depth <= shallow;
        }

        /**
         * Whether the whole body overlaps a row that its core touches. If a concave body has something exactly between two of its sides, its core may
         * touch that, but the body does not overlap it. So the row is made smaller instead, and must touch the body then. In the ground, a piece of
         * the body must be deep.
         */
        public function wholeOverlaps(body:MovingBody, row:int, place:Vector3D):Boolean
        {
            var other:Body = body.bodyOf(row);
            var whole:Body = body.wholeAt(place);
            if (other.form == ModelShape.GROUND)
            {
                return GroundPairTests(body.pairTestsFor(whole, other)).isDeeper(whole, other, body.core.slop);
            }
            _smaller.readShrunk(other, null, BodyCore.shrinkOf(other, body.core.slop));
            return body.areTouching(whole, _smaller);
        }

        /** Whether the body passes a row that its core touches, because the row is one-way, and the body does not rest on it. */
        public function passesAt(body:MovingBody, row:int, place:Vector3D):Boolean
        {
            return body.isOneWay(row) && (!findContact(body, row, place, true, _contact) || body.passes(row, _contact));
        }

        /**
         * Finds the deepest overlap with some rows. A shallow one does not count, nor one with a one-way row.
         *
         * @param out receives the contact. A push along its normal by its depth leads a clearance out of the row
         * @return the sum of the depths of all overlaps; 0 if there is none
         */
        public function findDeepest(body:MovingBody, rows:IntList, place:Vector3D, out:ContactPoint):Number
        {
            var sum:Number = 0;
            out.depth = 0;
            for (var i:int = 0; i < rows.count; i++)
            {
                var row:int = rows.numbers[i];
                if (body.isOneWay(row) || !body.coreTouches(row, place) || findContact(body, row, place, true, _contact) || !wholeOverlaps(body, row, place))
                {
                    continue;
                }
                warnIfInside(body, row, _contact);
                _contact.depth += body.core.clearance;
                // the shortest way out of a tree may lead through a wall of the tree if it is longer than the way to the middle of the body
                if (body.bodyOf(row).form != ModelShape.TREE || _contact.depth <= OverlapMiddle.halfAlong(body.source, _contact))
                {
                    sum += _contact.depth;
                    if (_contact.depth > out.depth)
                    {
                        out.copyFrom(_contact);
                    }
                }
            }
            return sum;
        }

        /**
         * Warns of a motion that begins so deep inside of a tree that the tree does not stop it: in a closed room, for example, which is solid. Warns
         * too if all of the body begins inside of another structure, with room to spare: inside of the structure around a level, for example.
         */
        public static function warnIfInside(body:MovingBody, row:int, contact:ContactPoint):void
        {
            var form:int = body.bodyOf(row).form;
            var isTree:Boolean = form == ModelShape.TREE;
            var source:Body = body.source;
            var allowed:Number = OverlapMiddle.halfAlong(source, contact);
            if (!isTree)
            {
                allowed *= WITH_ROOM;
            }
            if (form != ModelShape.GROUND && contact.depth > allowed)
            {
                var below:Number = source.placement.r22 == 1 ? source.halfZ - source.offsetZ : 0;
                warnOfInside(body.agents, row, source.shape.modelName, source.placement, below, contact.depth, isTree);
            }
        }
    }
}

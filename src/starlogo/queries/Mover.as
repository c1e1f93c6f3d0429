// This file is long because all steps of a motion share where the row is and what it is kept away from.
package starlogo.queries
{
    import starlogo.agents.Agent;
    import starlogo.broadphase.Extents;
    import starlogo.collision.Contact;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.sweep.RelativeMotion;
    import starlogo.search.AgentTable;
    import starlogo.search.RowSweep;
    import starlogo.search.Separation;
    import starlogo.search.ShapeStrategy;

    use namespace engine;

    /**
     * Moves a row of a table among others, until it touches one or along what it touches.
     *
     * <p>What it touches at the beginning, or meets, it is kept a hair away from while it moves: by an offset. So a sweep that begins there finds what
     * it meets next, whatever shapes they have, and a touch that it leaves or runs along is none. Where no offset is free of a touch, as
     * between two walls that leave no room, or in a deep overlap, the plane of the contact stands for the other: it must not be
     * crossed, and nothing else of the other counts.</p>
     *
     * <p>Sliding is the projection on the planes of all that was touched (Fauerby, "Improved collision detection and response", 2003, with all planes
     * kept).</p>
     *
     * @private
     */
    public final class Mover
    {
        // A hair, as a part of what depths may be off; how deep it is in a touch that it ends in; overlaps deeper than so many are planes.
        private static const HAIR:Number = 0.02 * Tolerances.SEPARATION;
        private static const DIP:Number = 0.02 * Tolerances.SEPARATION;
        private static const DEEP:Number = 10 * Tolerances.SEPARATION;

        // How far on a touch is looked at that may be of no consequence, as a part of the larger extent.
        private static const AHEAD:Number = 1e-4;

        private static const CLEARING_ROUNDS:int = 6;
        private static const MOST_PLANES:int = 8;
        private static const MOST_TOUCHES:int = 64;

        // When the last touch of a motion is, at the latest: so that some of it is left, which has its direction.
        private static const LAST:Number = 1 - 1e-15;

        // The sine of the angle up to which a motion runs along a plane; the square of the share of a motion that is none.
        private static const LEVEL:Number = 1e-12;
        private static const STUCK:Number = 1e-20;

        /** Decides what touches. */
        public var strategy:ShapeStrategy;

        /** How far the last row has come, as a part of its motion. */
        public var part:Number = 1;

        /** Where the agent is at the end. */
        public var x:Number = 0;

        /** @copy #x */
        public var y:Number = 0;

        /** @copy #x */
        public var z:Number = 0;

        private var _sweep:RowSweep;
        private var _separation:Separation;

        // The row that moves, and the others: the first of all that count, until the motion turns.
        private var _table:AgentTable;
        private var _row:int;
        private var _others:Vector.<int> = new Vector.<int>();
        private var _count:int = 0;
        private var _all:int = 0;

        // What is left of the motion, and how far it has gone.
        private var _restX:Number = 0;
        private var _restY:Number = 0;
        private var _restZ:Number = 0;
        private var _gone:Number = 0;

        // From where it is to where it is a hair away from all that it touches.
        private var _offsetX:Number = 0;
        private var _offsetY:Number = 0;
        private var _offsetZ:Number = 0;

        // The contacts whose planes must not be crossed.
        private var _planes:Vector.<ContactPoint> = new Vector.<ContactPoint>();
        private var _planeCount:int = 0;

        // What it meets first, when, and how; room for a candidate's.
        private var _first:int = -1;
        private var _time:Number = 0;
        private var _contact:ContactPoint = new ContactPoint();
        private var _tried:ContactPoint = new ContactPoint();
        private var _hasContact:Boolean = false;
        private var _motion:RelativeMotion = new RelativeMotion();

        // Fields in place of results, of which V8 would make objects: of the moving row and the other that is looked at the larger extent, and a hair.
        private var _extent:Number = 0;
        private var _hair:Number = 0;

        // How far the rest of the motion goes along a normal; how much of it the row is put ahead; how far the offset grows along a normal.
        private var _along:Number = 0;
        private var _ahead:Number = 0;
        private var _by:Number = 0;

        // The projection that is tried, and the best so far.
        private var _triedX:Number = 0;
        private var _triedY:Number = 0;
        private var _triedZ:Number = 0;
        private var _bestX:Number = 0;
        private var _bestY:Number = 0;
        private var _bestZ:Number = 0;
        private var _bestSquared:Number = 0;

        /** @param strategy decides what touches */
        public function Mover(strategy:ShapeStrategy)
        {
            this.strategy = strategy;
            _sweep = new RowSweep(strategy);
            _separation = new Separation(strategy, _sweep);
            while (_planes.length < MOST_PLANES)
            {
                _planes.push(new ContactPoint());
            }
        }

        /** Sets the motion of the next row: objects would be made of Numbers that are given to a longer function. */
        public function aim(dx:Number, dy:Number, dz:Number):void
        {
            _restX = dx;
            _restY = dy;
            _restZ = dz;
        }

        /**
         * Moves a row as was aimed; it is back where it was afterwards, and x, y, z are where it would be, part how far it has come.
         *
         * @param table has the row
         * @param row moves
         * @param others of the same table, as agents
         * @param slides whether it goes on along what it meets
         */
        public function move(table:AgentTable, row:int, others:Vector.<Agent>, slides:Boolean):void
        {
            _table = table;
            _row = row;
            readOthers(others);
            var atX:Number = x = table.x[row];
            var atY:Number = y = table.y[row];
            var atZ:Number = z = table.z[row];
            var revision:int = table.revisions[row];
            part = _gone = 0;
            _offsetX = _offsetY = _offsetZ = 0;
            _planeCount = 0;
            _hasContact = false;
            var squared:Number = _restX * _restX + _restY * _restY + _restZ * _restZ;
            if (squared > Tolerances.VANISHING)
            {
                clear();
                _all = _count;
                if (slides)
                {
                    slideOn();
                }
                else
                {
                    goUntilTouch();
                }
                end(slides);
                part = slides ? _gone / Math.sqrt(squared) : _gone;
                part = part < 1 ? part : 1;
            }
            else
            {
                _time = 1;
                advance();
                part = 1;
            }
            table.x[row] = atX;
            table.y[row] = atY;
            table.z[row] = atZ;
            table.putBack(row, revision);
            _table = null;
        }

        /** Moves an agent to x, y, z. */
        public function place(agent:Agent):void
        {
            var of:Placement = agent.placement;
            if (!(x * x + y * y + z * z <= 1e240))
            {
                // too far
                agent.moveTo(x, y, z);
            }
            // as moveTo, of whose Numbers V8 makes objects here
            if (x != of.x || y != of.y || z != of.z)
            {
                of.x = x;
                of.y = y;
                of.z = z;
                agent.revision++;
            }
        }

        /** Writes the contact of the last move that was not sliding. */
        public function writeContact(out:Contact):void
        {
            out.time = part;
            if (_hasContact)
            {
                out.point.x = _contact.x;
                out.point.y = _contact.y;
                out.point.z = _contact.z;
                out.normal.x = _contact.normalX;
                out.normal.y = _contact.normalY;
                out.normal.z = _contact.normalZ;
                out.depth = _contact.depth;
            }
        }

        private function readOthers(others:Vector.<Agent>):void
        {
            _count = 0;
            for (var i:int = 0; i < others.length; i++)
            {
                var row:int = _table.rowOf(others[i]);
                if (_table.shapes[row] != null)
                {
                    _others[_count] = row;
                    _count++;
                }
            }
        }

        // Finds an offset that is free of the touches at the beginning. What it is not free of becomes a plane.
        private function clear():void
        {
            for (var round:int = 0; round < CLEARING_ROUNDS; round++)
            {
                var isFree:Boolean = true;
                for (var i:int = _count - 1; i >= 0; i--)
                {
                    var other:int = _others[i];
                    putHere();
                    if (!strategy.areTouching(_table, _row, other))
                    {
                        continue;
                    }
                    isFree = false;
                    findStanding(other);
                    measure(other);
                    if (round == CLEARING_ROUNDS - 1 || _tried.depth > DEEP * _extent)
                    {
                        addPlane(_tried);
                        leaveOut(i);
                        continue;
                    }
                    _by = _tried.depth + _hair;
                    addOffset(_tried);
                }
                if (isFree)
                {
                    return;
                }
            }
        }

        // The contact with a row that touches where the moving one is, with its offset.
        private function findStanding(other:int):void
        {
            _motion.endAfter(0, 0, 0);
            _motion.time = 0;
            _sweep.findContact(_table, _row, other, _motion, _tried);
            _separation.find(_table, _row, other, _motion, _tried);
        }

        private function goUntilTouch():void
        {
            if (isAgainstPlanes())
            {
                return;
            }
            for (var touches:int = MOST_TOUCHES; touches > 0 && findFirst(); touches--)
            {
                if (isLeft() || isOfNoConsequence())
                {
                    continue;
                }
                // without the offset it would have been there before
                findAlong(_contact);
                if (_along < 0)
                {
                    _time += (_offsetX * _contact.normalX + _offsetY * _contact.normalY + _offsetZ * _contact.normalZ) / _along;
                }
                _time = _time > 0 ? _time : 0;
                _hasContact = true;
                _contact.depth = 0;
                advance();
                turnAgainst();
                _gone = _time;
                return;
            }
            _time = 1;
            advance();
            _gone = 1;
        }

        private function slideOn():void
        {
            var touches:int = MOST_TOUCHES;
            while (touches > 0 && project())
            {
                touches--;
                if (!findFirst())
                {
                    _time = 1;
                    goOn();
                    return;
                }
                if (isLeft() || isOfNoConsequence())
                {
                    continue;
                }
                goOn();
                _count = _all;
                if (_planeCount == MOST_PLANES)
                {
                    return;
                }
                turnAgainst();
                addPlane(_contact);
                stayFree();
            }
        }

        // A hair away from what it has met; where that touches something else, as in a corner, a hair back, where it was free.
        private function stayFree():void
        {
            measure(_others[_first]);
            _by = _hair;
            addOffset(_contact);
            putHere();
            if (!touchesOne())
            {
                return;
            }
            _by = -_hair;
            addOffset(_contact);
            findAlong(_contact);
            var back:Number = -_hair / _along;
            var most:Number = _time / (1 - _time);
            back = back < most ? back : most;
            x -= back * _restX;
            y -= back * _restY;
            z -= back * _restZ;
        }

        private function touchesOne():Boolean
        {
            for (var i:int = 0; i < _count; i++)
            {
                if (strategy.areTouching(_table, _row, _others[i]))
                {
                    return true;
                }
            }
            return false;
        }

        private function goOn():void
        {
            _gone += _time * Math.sqrt(_restX * _restX + _restY * _restY + _restZ * _restZ);
            advance();
        }

        // As far as the time says.
        private function advance():void
        {
            var time:Number = _time;
            x += time * _restX;
            y += time * _restY;
            z += time * _restZ;
            _restX *= 1 - time;
            _restY *= 1 - time;
            _restZ *= 1 - time;
        }

        // A contact that does not point against the motion is of features that do not stop it: what does is found a little way on.
        private function turnAgainst():void
        {
            findAlong(_contact);
            if (_along < 0)
            {
                return;
            }
            _ahead = 0;
            putAhead();
            if (strategy.areTouching(_table, _row, _others[_first]))
            {
                findStanding(_others[_first]);
                findAlong(_tried);
                if (_along < 0)
                {
                    _contact.copyFrom(_tried);
                    return;
                }
            }
            _contact.setNormal(-_restX, -_restY, -_restZ);
            _contact.normalise();
        }

        // Whether what is met first is no farther than rounding from where it is, and the motion leaves it or runs along it: then a hair away it is not met.
        private function isLeft():Boolean
        {
            findAlong(_contact);
            if (_time > 0 || _along < 0)
            {
                return false;
            }
            measure(_others[_first]);
            _by = _hair;
            addOffset(_contact);
            return true;
        }

        // Whether what is met first is convex and gets no deeper than a hair: the motion runs along it. It does not count then any more.
        private function isOfNoConsequence():Boolean
        {
            var other:int = _others[_first];
            if (!isConvex(other))
            {
                return false;
            }
            _ahead = _time;
            putAhead();
            if (strategy.areTouching(_table, _row, other))
            {
                _tried.depth = 0;
                findStanding(other);
                measure(other);
                findAlong(_tried);
                if (_tried.depth > 2 * _hair || _along < -_hair)
                {
                    return false;
                }
            }
            leaveOut(_first);
            return true;
        }

        private function isConvex(other:int):Boolean
        {
            return (_table.shapes[_row].isSphere && _table.shapes[other].isSphere) || strategy.hasExactContact(_table, _row, other);
        }

        // Ends where it has come to, if that is a hair away from all; else with the offset.
        private function end(slides:Boolean):void
        {
            if (!slides)
            {
                if (_hasContact && _first < 0)
                {
                    return;
                }
                if (_hasContact)
                {
                    measure(_others[_first]);
                    var dip:Number = DIP * _extent;
                    x -= dip * _contact.normalX;
                    y -= dip * _contact.normalY;
                    z -= dip * _contact.normalZ;
                    return;
                }
            }
            if (_offsetX == 0 && _offsetY == 0 && _offsetZ == 0)
            {
                return;
            }
            var offsetX:Number = _offsetX;
            var offsetY:Number = _offsetY;
            var offsetZ:Number = _offsetZ;
            _offsetX = -offsetX;
            _offsetY = -offsetY;
            _offsetZ = -offsetZ;
            putHere();
            if (touchesOne())
            {
                x += offsetX;
                y += offsetY;
                z += offsetZ;
            }
        }

        // Finds what the rest of the motion meets first.
        private function findFirst():Boolean
        {
            _ahead = 1;
            put();
            _motion.endAfter(_restX, _restY, _restZ);
            _time = RelativeMotion.NEVER;
            for (var i:int = 0; i < _count; i++)
            {
                _sweep.findImpact(_table, _row, _others[i], _motion, _tried);
                if (_motion.time < _time)
                {
                    _time = _motion.time;
                    _first = i;
                    _contact.copyFrom(_tried);
                }
            }
            if (_time > 1)
            {
                return false;
            }
            _time = _time < LAST ? _time : LAST;
            return true;
        }

        // Puts the row, with its offset, as far ahead along the rest of the motion.
        private function put():void
        {
            _table.x[_row] = x + _offsetX + _ahead * _restX;
            _table.y[_row] = y + _offsetY + _ahead * _restY;
            _table.z[_row] = z + _offsetZ + _ahead * _restZ;
            _table.displace(_row);
        }

        private function putHere():void
        {
            _ahead = 0;
            put();
        }

        // A little farther ahead.
        private function putAhead():void
        {
            var length:Number = Math.sqrt(_restX * _restX + _restY * _restY + _restZ * _restZ);
            measure(_others[_first]);
            _ahead += AHEAD * _extent / length;
            put();
        }

        private function addOffset(contact:ContactPoint):void
        {
            _offsetX += _by * contact.normalX;
            _offsetY += _by * contact.normalY;
            _offsetZ += _by * contact.normalZ;
        }

        private function leaveOut(at:int):void
        {
            _count--;
            _others[at] = _others[_count];
        }

        // Finds the larger extent of the moving row and another, and how wide a hair is between them.
        private function measure(other:int):void
        {
            var extents:Extents = _table.extents;
            var half:Number = Math.max(extents.halfX[_row], Math.max(extents.halfY[_row], extents.halfZ[_row]));
            half = Math.max(half, Math.max(extents.halfX[other], Math.max(extents.halfY[other], extents.halfZ[other])));
            _extent = 2 * half;
            _hair = HAIR * _extent + 8 * Tolerances.PLACES * (Math.abs(x) + Math.abs(y) + Math.abs(z)
                    + (Math.abs(_table.x[other]) + Math.abs(_table.y[other]) + Math.abs(_table.z[other])));
        }

        private function findAlong(contact:ContactPoint):void
        {
            _along = contact.normalX * _restX + contact.normalY * _restY + contact.normalZ * _restZ;
        }

        private function addPlane(contact:ContactPoint):void
        {
            if (_planeCount < MOST_PLANES)
            {
                _planes[_planeCount].copyFrom(contact);
                _planeCount++;
            }
        }

        // Whether the motion crosses a plane by more than rounding; what it does by rounding is taken off.
        private function isAgainstPlanes():Boolean
        {
            var least:Number = 0;
            for (var i:int = 0; i < _planeCount; i++)
            {
                findAlong(_planes[i]);
                if (_along < least)
                {
                    least = _along;
                    _contact.copyFrom(_planes[i]);
                }
            }
            measure(_row);
            if (least < -HAIR * _extent)
            {
                _first = -1;
                _hasContact = true;
                return true;
            }
            return least < 0 && !project();
        }

        // Projects the rest of the motion on the planes that it crosses, the nearest that crosses none; returns whether there is any left.
        private function project():Boolean
        {
            var most:Number = _restX * _restX + _restY * _restY + _restZ * _restZ;
            _bestX = _bestY = _bestZ = _bestSquared = 0;
            _triedX = _restX;
            _triedY = _restY;
            _triedZ = _restZ;
            tryRest();
            var isFree:Boolean = _bestSquared > 0;
            for (var i:int = 0; !isFree && i < _planeCount; i++)
            {
                tryOnPlane(_planes[i]);
            }
            for (i = 0; _bestSquared == 0 && i < _planeCount; i++)
            {
                tryOnCreases(i);
            }
            _restX = _bestX;
            _restY = _bestY;
            _restZ = _bestZ;
            return _bestSquared > STUCK * most;
        }

        private function tryOnPlane(plane:ContactPoint):void
        {
            findAlong(plane);
            _triedX = _restX - _along * plane.normalX;
            _triedY = _restY - _along * plane.normalY;
            _triedZ = _restZ - _along * plane.normalZ;
            tryRest();
        }

        // The lines in which one plane meets those after it.
        private function tryOnCreases(first:int):void
        {
            var a:ContactPoint = _planes[first];
            for (var i:int = first + 1; i < _planeCount; i++)
            {
                var b:ContactPoint = _planes[i];
                var cx:Number = a.normalY * b.normalZ - a.normalZ * b.normalY;
                var cy:Number = a.normalZ * b.normalX - a.normalX * b.normalZ;
                var cz:Number = a.normalX * b.normalY - a.normalY * b.normalX;
                var squared:Number = cx * cx + cy * cy + cz * cz;
                if (squared > Tolerances.NEARLY_PARALLEL)
                {
                    var share:Number = (cx * _restX + cy * _restY + cz * _restZ) / squared;
                    _triedX = share * cx;
                    _triedY = share * cy;
                    _triedZ = share * cz;
                    tryRest();
                }
            }
        }

        // Takes the projection that is tried, if it crosses no plane and is longer than the best so far.
        private function tryRest():void
        {
            var squared:Number = _triedX * _triedX + _triedY * _triedY + _triedZ * _triedZ;
            if (!(squared > _bestSquared))
            {
                return;
            }
            var least:Number = -LEVEL * Math.sqrt(squared);
            for (var i:int = 0; i < _planeCount; i++)
            {
                var plane:ContactPoint = _planes[i];
                if (plane.normalX * _triedX + plane.normalY * _triedY + plane.normalZ * _triedZ < least)
                {
                    return;
                }
            }
            _bestX = _triedX;
            _bestY = _triedY;
            _bestZ = _triedZ;
            _bestSquared = squared;
        }
    }
}

package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.collision.Contact;
    import starlogo.convex.ContactPoint;
    import starlogo.data.IntList;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.queries.motion.MotionResult;
    import starlogo.queries.motion.MovingBody;
    import starlogo.queries.motion.SlideLimits;
    import starlogo.queries.motion.SlideResult;
    import starlogo.queries.motion.Slider;
    import starlogo.queries.motion.StartLift;
    import starlogo.queries.motion.TouchSweep;
    import starlogo.queries.rays.Hits;
    import starlogo.queries.rays.SpareHits;
    import starlogo.queries.trees.Collector;
    import starlogo.search.Body;
    import starlogo.search.ModelShape;

    use namespace engine;

    /**
     * Answers how far an agent or a structure can go. Some questions move the agent there. The casts move nothing. AgentWalks says what each
     * question means.
     *
     * @private
     */
    public final class MoveQueries
    {
        private var _seen:SeenAgents;

        private var _touches:TouchSweep = new TouchSweep();
        private var _slider:Slider = new Slider();
        private var _hits:Hits;
        private var _spare:SpareHits = new SpareHits(ShapeHit);

        // By the nesting of a question (SeenAgents.nesting): its body.
        private var _bodies:Vector.<MovingBody> = new Vector.<MovingBody>();

        // Where the body begins, and its motion. They are set when it is known which rows are near.
        private var _from:Vector3D = new Vector3D();
        private var _motion:Vector3D = new Vector3D();

        // How motions end.
        private var _result:MotionResult = new MotionResult();
        private var _slid:SlideResult = new SlideResult();

        // The lift out of all rows near the way, with which the body begins.
        private var _lift:StartLift = new StartLift();

        // Where the row that is met first stops the body.
        private var _end:Vector3D = new Vector3D();

        /** @param seen the agents that the questions are about */
        public function MoveQueries(seen:SeenAgents)
        {
            _seen = seen;
            _hits = new Hits(seen);
        }

        /** See AgentWalks.castShape. */
        public function castShape(structure:BoundingStructure, dx:Number, dy:Number, dz:Number, filter:AgentFilter, hit:ShapeHit):ShapeHit
        {
            var body:MovingBody = nestedBody();
            body.readStructure(structure);
            return cast(body, null, dx, dy, dz, filter, hit);
        }

        /** See AgentWalks.castShapeAll. */
        public function castShapeAll(structure:BoundingStructure, dx:Number, dy:Number, dz:Number, filter:AgentFilter,
                out:Vector.<ShapeHit>):Vector.<ShapeHit>
        {
            var body:MovingBody = nestedBody();
            body.readStructure(structure);
            return castAll(body, null, dx, dy, dz, filter, out);
        }

        /** See AgentWalks.castAgent. */
        public function castAgent(agent:Agent, dx:Number, dy:Number, dz:Number, filter:AgentFilter, hit:ShapeHit):ShapeHit
        {
            var body:MovingBody = nestedBody();
            body.readCastAgent(agent);
            return cast(body, agent, dx, dy, dz, filter, hit);
        }

        /** See AgentWalks.castAgentAll. */
        public function castAgentAll(agent:Agent, dx:Number, dy:Number, dz:Number, filter:AgentFilter, out:Vector.<ShapeHit>):Vector.<ShapeHit>
        {
            var body:MovingBody = nestedBody();
            body.readCastAgent(agent);
            return castAll(body, agent, dx, dy, dz, filter, out);
        }

        /** See AgentWalks.moveUntilTouch. */
        public function moveUntilTouch(agent:Agent, dx:Number, dy:Number, dz:Number, filter:AgentFilter, contact:Contact):Number
        {
            _seen.requireMovable(agent, "moveUntilTouch");
            var body:MovingBody = nestedBody();
            body.readAgent(agent);
            var isMet:Boolean = findStops(body, agent, dx, dy, dz, filter, 1, _end) > 0;
            var fraction:Number = isMet ? _hits.keyOf(0) : 1;
            // before the contact is written, because an agent that would leave the world throws an error
            if (dx != 0 || dy != 0 || dz != 0)
            {
                _seen.moveAgent(agent, _end);
            }
            if (contact != null)
            {
                contact.time = fraction;
                if (isMet)
                {
                    var from:ContactPoint = _hits.contactOf(0);
                    contact.read(from);
                    contact.approachSpeed = Math.max(0, -from.along(_motion));
                }
            }
            return fraction;
        }

        /** See AgentWalks.slide. */
        public function slide(agent:Agent, dx:Number, dy:Number, dz:Number, filter:AgentFilter):Number
        {
            return moveSliding(agent, dx, dy, dz, filter, SlideLimits.NONE);
        }

        /** Slides, but at the agent's height: a slope is an upright wall. The errors are those of <code>slide()</code>. */
        public function slideLevel(agent:Agent, dx:Number, dy:Number, filter:AgentFilter):Number
        {
            return moveSliding(agent, dx, dy, 0, filter, SlideLimits.LEVEL);
        }

        // The body of a question that begins now.
        private function nestedBody():MovingBody
        {
            while (_bodies.length <= _seen.nesting)
            {
                _bodies.push(new MovingBody(_seen));
            }
            return _bodies[_seen.nesting];
        }

        private function moveSliding(agent:Agent, dx:Number, dy:Number, dz:Number, filter:AgentFilter, limits:SlideLimits):Number
        {
            _seen.requireMovable(agent, "slide");
            var body:MovingBody = nestedBody();
            body.readAgent(agent);
            requireMotion(dx, dy, dz, agent);
            body.findRowsWithin(Math.sqrt(dx * dx + dy * dy + dz * dz), 0, 0, agent, filter);
            setMotion(body, dx, dy, dz);
            var fraction:Number = _slider.slide(body, body.rows, _from, _motion, limits, _slid);
            _slider.restoreClearance(body, _slid.place);
            if (limits.staysLevel)
            {
                // the clearance leads off slopes by their normals
                _slid.place.z = _from.z;
            }
            if (dx != 0 || dy != 0 || dz != 0)
            {
                _seen.moveAgent(agent, _slid.place);
            }
            return fraction;
        }

        private function cast(body:MovingBody, asker:Agent, dx:Number, dy:Number, dz:Number, filter:AgentFilter, hit:ShapeHit):ShapeHit
        {
            return findStops(body, asker, dx, dy, dz, filter, 1, null) == 0 ? null : write(0, hit || new ShapeHit());
        }

        private function castAll(body:MovingBody, asker:Agent, dx:Number, dy:Number, dz:Number, filter:AgentFilter, out:Vector.<ShapeHit>):Vector.<ShapeHit>
        {
            var hits:Vector.<ShapeHit> = out || new Vector.<ShapeHit>();
            _spare.resize(hits, findStops(body, asker, dx, dy, dz, filter, Collector.ALL, null));
            for (var i:int = 0; i < hits.length; i++)
            {
                write(i, hits[i]);
            }
            return hits;
        }

        private function setMotion(body:MovingBody, dx:Number, dy:Number, dz:Number):void
        {
            var at:Placement = body.source.placement;
            _motion.setTo(dx, dy, dz);
            _from.setTo(at.x, at.y, at.z);
        }

        // Finds the rows that stop the body on a straight way, each as if the others were not there. If an end is given, it receives the place where
        // the first of them stops the body. The asker is null if a structure is cast. Returns how many hits the answer has.
        private function findStops(body:MovingBody, asker:Agent, dx:Number, dy:Number, dz:Number, filter:AgentFilter, wanted:int, end:Vector3D):int
        {
            requireMotion(dx, dy, dz, asker);
            body.findRowsAlong(dx, dy, dz, asker, filter);
            setMotion(body, dx, dy, dz);
            _lift.clear();
            // a floor may be many rows: what is lifted out of one of them does not run into the next
            var found:Collector = _seen.ask(wanted, Infinity, null, null);
            if (collectLifted(body, found, end) && _touches.findLift(body, body.rows, _from, _motion, _lift))
            {
                found = _seen.ask(wanted, Infinity, null, null);
                collectLifted(body, found, end);
            }
            return _hits.end(found);
        }

        // Finds the rows that stop the body if it begins with the lift. Returns whether a common lift of all rows could change the answer.
        private function collectLifted(body:MovingBody, found:Collector, end:Vector3D):Boolean
        {
            var rows:IntList = body.rows;
            var mayLift:Boolean = false;
            _hits.begin();
            if (end != null)
            {
                _lift.findEnd(_from, _motion, 1, body.core.slop, end);
            }
            // what stops the body at once does not end the loop, because a row behind it may lift the body
            for (var i:int = 0; i < rows.count; i++)
            {
                var row:int = rows.numbers[i];
                _touches.findTouch(body, row, _from, _motion, _lift, _result);
                mayLift ||= _result.isLifted || (_result.fraction == 0 && !_result.isDeep);
                if (_result.row >= 0)
                {
                    var isFirst:Boolean = _result.fraction < found.limit;
                    found.add(row, _result.fraction);
                    _hits.add(row, _result.fraction).copyFrom(_result.contact);
                    if (end != null && isFirst)
                    {
                        _touches.goIntoTouch(body, _result);
                        end.copyFrom(_result.place);
                    }
                }
            }
            return mayLift;
        }

        // Writes how the body touches a row of the answer.
        private function write(index:int, hit:ShapeHit):ShapeHit
        {
            var body:Body = _hits.bodyOf(index);
            var contact:ContactPoint = _hits.contactOf(index);
            if (body.form != ModelShape.TREE)
            {
                // it may be a triangle of what is cast
                contact.triangle = -1;
            }
            else if (contact.triangle < 0)
            {
                contact.triangle = _seen.table.narrowPhase.treeTests.nearestTriangle(body, contact);
            }
            _hits.write(index, hit);
            hit.time = _hits.keyOf(index);
            return hit;
        }
    }
}

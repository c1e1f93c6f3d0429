package starlogo.queries
{
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.bounding.Sphere;
    import starlogo.collision.Contact;
    import starlogo.models.BuiltInModel;
    import starlogo.terrain.Terrain;
    import starlogo.terrain.WorldBounds;
    import support.EachCollider;
    import support.Garbage;
    import support.MemoryGrowth;
    import support.landOf;

    /** Questions allocate nothing once they have been asked, if out is given; nor do updates. As AllocationTest. */
    public class QueriesAllocationTest
    {
        private static const AGENTS:int = 40;
        private static const ASK_EVERY:int = 20;
        // frames in which all turn about once, an even number: then they are where they were
        private static const TURN:int = 6;

        // bytes in all, less than a small object each time that someone asks; in Adobe's VM some pages
        private static const NOTHING:Number = 2000;
        private static const PAGES:Number = 3 * 4096;

        private var _agents:Vector.<Agent>;
        private var _queries:AgentQueries;
        private var _filter:AgentFilter;
        private var _ground:Terrain;
        private var _bounds:WorldBounds = new WorldBounds(-6, -6, -6, 6, 6, 6);
        private var _capsule:Agent;
        private var _guests:Vector.<Agent>;
        private var _out:Vector.<Agent> = new Vector.<Agent>();
        private var _structure:Sphere = new Sphere(new Vector3D(), 3);
        private var _point:Vector3D = new Vector3D();
        private var _direction:Vector3D = new Vector3D();
        private var _hit:RayHit = new RayHit();
        private var _contact:Contact = new Contact();
        private var _hits:Vector.<RayHit> = new Vector.<RayHit>();
        private var _shapeHit:ShapeHit = new ShapeHit();
        private var _shapeHits:Vector.<ShapeHit> = new Vector.<ShapeHit>();
        private var _options:WalkOptions = new WalkOptions();
        private var _footing:Footing = new Footing();
        private var _answers:int;

        [Test]
        public function questionsAllocateNothing():void
        {
            for each (var name:String in EachCollider.NAMES)
            {
                makeGame(name);
                assertAllocatesNothing(name + ", near", askWhoIsNear);
                assertAllocatesNothing(name + ", some near", askWhoOfSomeIsNear);
                assertAllocatesNothing(name + ", touching", askWhoTouches);
                assertAllocatesNothing(name + ", moved", askAgain);
                assertAllocatesNothing(name + ", rays", askWhatRaysMeet);
                assertAllocatesNothing(name + ", motions", askHowFar);
                assertAllocatesNothing(name + ", distances", askHowFarApart);
                assertAllocatesNothing(name + ", the ground and the edges", askHowFarFromTheWorld);
                _queries.terrain = _ground;
                assertAllocatesNothing(name + ", distances to points", askHowFarFromAPoint);
                // Among triangles, an interpreter takes a minute for them.
                if (Garbage.isCounted || name != "triangles")
                {
                    assertAllocatesNothing(name + ", casts of shapes", askWhatShapesMeet);
                    assertAllocatesNothing(name + ", walks", askHowItWalks);
                }
            }
        }

        private function assertAllocatesNothing(message:String, ask:Function):void
        {
            _answers = 0;
            Garbage.assumeKept();
            // after a whole turn of all agents no list has to grow
            var frames:int = Garbage.isCounted ? 50 * TURN : TURN;
            var most:Number = Garbage.isCounted ? PAGES : NOTHING;
            var grown:Number = growthIn(frames, ask);
            if (grown > most)
            {
                // questions would allocate in each turn; the player itself does so now and then
                grown = growthIn(frames, ask);
            }
            assertTrue("something is found", _answers > frames * _guests.length);
            assertTrue(message + ": " + Math.round(grown) + " bytes in " + frames + " frames", grown <= most);
        }

        private function growthIn(frames:int, ask:Function):Number
        {
            return MemoryGrowth.during(frames, TURN, function(i:int):void
                {
                    askAll(ask);
                });
        }

        private function makeGame(name:String):void
        {
            var greatLand:GreatLand = landOf(BuiltInModel.sphere(), BuiltInModel.cube(), BuiltInModel.cylinder());
            var random:SeededRandom = new SeededRandom(42);
            _agents = new Vector.<Agent>();
            _guests = new Vector.<Agent>();
            for (var i:int = 0; i < AGENTS; i++)
            {
                var agent:Agent = new Agent(random.pick(["sphere", "cube", "cylinder"]), random.pick(["bears", "balls", "walls"]));
                agent.moveTo(random.between(-8, 8), random.between(-8, 8), random.between(0, 1));
                agent.size = random.pick([0.25, 1, 1, 3]);
                _agents.push(agent);
            }
            for each (var shape:String in ["sphere", "cube", "cylinder"])
            {
                _guests.push(new Agent(shape));
            }
            _capsule = new Agent("cube");
            _capsule.collideAs = Agent.CAPSULE;
            _ground = makeHill();
            _filter = AgentFilter.ofBreeds("bears", "balls");
            _filter.except = new <Agent>[_agents[0]];
            _queries = new AgentQueries(EachCollider.make(name, greatLand));
            _answers = 0;
        }

        private function askAll(ask:Function):void
        {
            for (var i:int = 0; i < AGENTS; i++)
            {
                var agent:Agent = _agents[i];
                agent.heading += 360 / TURN;
                agent.moveTo(-agent.x, agent.y, agent.z);
            }
            _queries.update(_agents);
            for (i = 0; i < AGENTS; i += ASK_EVERY)
            {
                ask(_agents[i]);
            }
            for (i = 0; i < _guests.length; i++)
            {
                ask(_guests[i]);
            }
        }

        private function askWhoIsNear(agent:Agent):void
        {
            _answers += _queries.near(agent, 3, null, _out).length;
            _answers += _queries.countNear(agent, 3);
            _answers += _queries.inCone(agent, 3, 90, null, _out).length;
            _answers += _queries.nearPoint(_point, 3, null, _out).length;
            _answers += _queries.countNearPoint(_point, 3);
            _answers += _queries.nearestToPoint(_point) == null ? 0 : 1;
            _answers += _queries.nearestOf(agent, 4, 3, null, _out).length;
            _queries.nearest(agent);
        }

        private function askWhoOfSomeIsNear(agent:Agent):void
        {
            _answers += _queries.near(agent, 3, _filter, _out).length;
            _answers += _queries.countNear(agent, 3, _filter);
            _answers += _queries.inCone(agent, 3, 90, _filter, _out).length;
            _queries.nearest(agent, 3, _filter);
        }

        private function askWhoTouches(agent:Agent):void
        {
            _answers += _queries.touching(agent, null, _out).length;
            _answers += _queries.touching(agent, _filter, _out).length;
            _answers += _queries.touchesAny(agent, _filter) ? 1 : 0;
            _answers += _queries.overlapping(_structure, null, _out).length;
        }

        private function askWhatRaysMeet(agent:Agent):void
        {
            _point.setTo(-9, 0, 1);
            _direction.setTo(agent.x + 9, agent.y, agent.z - 0.5);
            _answers += _queries.castAll(_point, _direction, Infinity, null, _hits).length;
            _answers += _queries.castAll(_point, _direction, 15, _filter, _hits).length;
            _answers += _queries.castAll(_point, _direction, Infinity, null, _hits, true).length;
            _answers += _queries.cast(_point, _direction, Infinity, null, _hit) == null ? 0 : 1;
            _answers += _queries.cast(_point, _direction, Infinity, _filter, _hit) == null ? 0 : 1;
            _answers += _queries.canSee(agent, _agents[1]) ? 1 : 0;
            _point.setTo(0, 0, 0);
        }

        // To and fro, until it touches and along what it touches; then back. The guests and one agent only: among triangles it takes long.
        private function askHowFar(agent:Agent):void
        {
            var place:int = _agents.indexOf(agent);
            if (place > 0)
            {
                return;
            }
            var x:Number = agent.x;
            var y:Number = agent.y;
            var z:Number = agent.z;
            _answers += _queries.moveUntilTouch(agent, 0.3, 0.1, 0, _filter, _contact) < 1 ? 1 : 0;
            _answers += _queries.slide(agent, -0.2, 0.3, 0) > 0 ? 1 : 0;
            _answers += _queries.slide(agent, 0.1, -0.3, 0.1, _filter) > 0 ? 1 : 0;
            agent.moveTo(x, y, z);
            if (place >= 0)
            {
                _queries.moved(agent);
            }
        }

        // The guests and one agent only, as above.
        private function askWhatShapesMeet(agent:Agent):void
        {
            _answers++;
            if (_agents.indexOf(agent) > 0)
            {
                return;
            }
            _answers += _queries.castShapeAll(_structure, agent.x, agent.y, 0, null, _shapeHits).length;
            _answers += _queries.castShape(_structure, agent.x, agent.y, 0, _filter, _shapeHit) == null ? 0 : 1;
            _answers += _queries.castAgentAll(agent, 5, 1, 0, null, _shapeHits).length;
            _answers += _queries.castAgent(agent, 5, 1, 0, _filter, _shapeHit) == null ? 0 : 1;
            _answers += _queries.overlapsAgent(agent, -agent.x, agent.y, 0) ? 1 : 0;
        }

        // The guests only, one after the other from the same place: over the hill, and where there is none.
        private function askHowItWalks(agent:Agent):void
        {
            _answers++;
            if (_agents.indexOf(agent) < 0)
            {
                agent.moveTo(-4, 0.5, 1);
                for (var i:int = 0; i < 2; i++)
                {
                    _answers += _queries.walk(agent, 0.8, 0, _options, _footing).stands ? 1 : 0;
                }
                agent.moveTo(0, 0, 0);
            }
        }

        private static function makeHill():Terrain
        {
            var terrain:Terrain = new Terrain(9, 9, 2, -8, -8);
            terrain.raiseMound(0, 0, 12, 1);
            return terrain;
        }

        private function askHowFarApart(agent:Agent):void
        {
            for each (var guest:Agent in _guests)
            {
                _answers += agent != guest && _queries.distance(agent, guest, _point, _direction) < 20 ? 1 : 0;
            }
            _point.setTo(0, 0, 0);
            _answers += _queries.distanceToPoint(agent, _point, _direction) < 20 ? 1 : 0;
        }

        // The queries have neither in their list.
        private function askHowFarFromTheWorld(agent:Agent):void
        {
            askAboutTheWorld(agent, _ground.agent);
            askAboutTheWorld(agent, _bounds.agent);
            _answers += _queries.touchesEdge(agent, _bounds) ? 1 : 0;
            _point.setTo(0, 0, 0);
        }

        private function askAboutTheWorld(agent:Agent, world:Agent):void
        {
            _answers += _queries.distance(agent, world, _point, _direction) < 20 ? 1 : 0;
            _answers += _queries.distance(world, agent) < 20 ? 1 : 0;
            _answers += _queries.touching(world, null, _out).length;
        }

        private function askHowFarFromAPoint(agent:Agent):void
        {
            _point.setTo(agent.x + 2, agent.y - 1, agent.z);
            for each (var guest:Agent in _guests)
            {
                _answers += _queries.distanceToPoint(guest, _point, _direction) < 20 ? 1 : 0;
            }
            _answers += _queries.distanceToPoint(agent, _point, _direction) < 20 ? 1 : 0;
            _answers += _queries.distanceToPoint(_capsule, _point, _direction) < 20 ? 1 : 0;
            _answers += _queries.distanceToPoint(_ground.agent, _point, _direction) < 20 ? 1 : 0;
            _point.setTo(0, 0, 0);
        }

        // The agent asks from where it is, and is told to have moved.
        private function askAgain(agent:Agent):void
        {
            var x:Number = agent.x;
            agent.moveTo(x + 0.01, agent.y, agent.z);
            _answers += _queries.touching(agent, null, _out).length;
            if (_agents.indexOf(agent) >= 0)
            {
                _queries.moved(agent);
            }
            _answers += _queries.touching(agent, null, _out).length;
            agent.moveTo(x, agent.y, agent.z);
        }
    }
}
